#pragma once

#include "descend.hpp"
#include "snapshot.hpp"

namespace planish::slit_detail {

/// A place of joined ends, their strips solved there.
struct JoinedPlace {
  Snapshot now;
  double value = 0.0;     ///< energy, load and wishes of all that moves, for D = 1 N mm
  Eigen::VectorXd slope;  ///< by the moves of `moves_of`, mm and radians
  bool met = false;       ///< all strips end there
  int iterations = 0;
};
JoinedPlace joined_place(const Snapshot& from, std::size_t run, const JoinedEnds& joined,
                         const DescentOptions& options);

/// Solves the strips of a run and finds where the uncut sheet beyond their slits lies: where the
/// energy of all is least, or where a strip's end was placed. Strips that could not be brought
/// there within the options stay open. Returns the iterations taken.
int settle_joined(Snapshot& now, std::size_t run, const DescentOptions& options);

}  // namespace planish::slit_detail
