#pragma once

#include "mend.hpp"

#include <XSAlgo_AlgoContainer.hxx>

namespace planish::brep {

/// How much had to be mended of what was read.
struct MendCount {
  int shapes = 0;  ///< that were read
  int faces = 0;   ///< mended one by one
  int whole = 0;   ///< shapes mended as a whole
};

/// As long as this lives the kernel's STEP reader mends what needs it (`mended`); by default it
/// mends all that it reads, at a cost that grows with the square of a face's loops. Requires the
/// exchange lock.
class MendWhereNeeded {
 public:
  MendWhereNeeded();
  MendWhereNeeded(const MendWhereNeeded&) = delete;
  MendWhereNeeded& operator=(const MendWhereNeeded&) = delete;
  ~MendWhereNeeded();

  const MendCount& count() const;

 private:
  Handle(XSAlgo_AlgoContainer) before_;
  Handle(XSAlgo_AlgoContainer) ours_;
};

}  // namespace planish::brep
