#pragma once

#include "seams.hpp"

#include <vector>

namespace planish::transition_detail {

/// The tips cut off at corners in which a sheet of real thickness has no room on its inside: at the
/// apex of a cone, and where several folds meet. The inside radius that remains there is a tenth of
/// the thickness.
class TipCuts {
 public:
  using PieceParts = std::vector<std::vector<PatchPart>>;

  TipCuts(const Ring& ring, const PieceParts& pieces, const TransitionSpec& spec);

  RuledPatch::Tips of(const RuledPatch& patch, double from, double to) const;

  /// Errors: `radius_too_small` if the cuts at both ends of a ruling leave nothing of it.
  Result<void> leave_room(const RuledPatch& patch, double from, double to) const;

 private:
  struct Tip {
    int side = 0;
    Vec3 at;
    double cut = 0.0;
  };
  void add_cones(const Ring& ring, double radius);
  void add_fans(const Ring& ring, const PieceParts& pieces, double inside, double radius);
  double at(int side, const Vec3& p) const;

  double near_, thickness_;
  std::vector<Tip> tips_;
};

}  // namespace planish::transition_detail
