#pragma once

#include <planish/slit/folded_slit_sheet.hpp>
#include <planish/slit/slit_sheet.hpp>

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace planish::slit_detail {

/// The uncut sheet beyond the slits of strips that it joins: a plane facet for each, side by side.
struct JoinedEnds {
  int first = 0, last = 0;    ///< strips
  Frame frame;                ///< of the first strip's facet, flat coordinates to space
  std::vector<double> turns;  ///< from facet to facet about the line between them, radians; away
                              ///< from the front as a positive fold
};

/// First and last strip of each run of neighbours that are joined.
std::vector<std::pair<int, int>> joined_strips(const SlitSheet& sheet);

/// The facets in space, from the strips' last ridges to the far line.
std::vector<PanelFacet> facets_of(const SlitSheet& sheet, const JoinedEnds& joined);

/// What may change of joined ends: the facet of this number and all after it move by
/// x ↦ move + turn × x.
struct JoinedMove {
  int from = 0;
  Vec3 move = Vec3::Zero(), turn = Vec3::Zero();
  Vec3 at(const Vec3& x) const { return move + turn.cross(x); }
};

/// Rigid moves of all facets, in symmetric sheets within the symmetry plane, then the turn at each
/// line between two. Turns of all are about the middle of the facets.
std::vector<JoinedMove> moves_of(const std::vector<PanelFacet>& facets, bool symmetric);

/// Joined ends after a step of each move, mm and radians.
JoinedEnds moved(const SlitSheet& sheet, const JoinedEnds& joined, bool symmetric,
                 const Eigen::VectorXd& step);

/// Bending energy for D = 1 N mm of the lines between facets, each standing for the sheet up to the
/// middles of the two, N mm; and the stiffness of each, so that the moment is turn · stiffness.
double turning_energy(const SlitSheet& sheet, const JoinedEnds& joined);
std::vector<double> turning_stiffness(const SlitSheet& sheet, const JoinedEnds& joined);

/// Area and centroid of a facet.
double area_of(const PanelFacet& facet);
Vec3 centroid_of(const PanelFacet& facet);

}  // namespace planish::slit_detail
