#pragma once

#include "strip_system.hpp"

#include <vector>

namespace planish::slit_detail {

/// Which of two strips lies on the other where they overlap: on top is the side of the normals.
enum class OnTop { left, right };

/// Two strips of a system beside each other, the left one first, and which is on top by station:
/// ridges and the middles between them in turn. Both have as many ridges.
struct StripPair {
  int left = 0, right = 0;
  std::vector<OnTop> on_top;
};

/// One strip on top everywhere.
StripPair pair_of(int left, int right, const FoldedStrip& shape, OnTop on_top);
/// In each stretch along which the strips overlap that one on top to which less is missing.
StripPair nearest_pair(int left, int right, const FoldedStrip& left_shape,
                       const FoldedStrip& right_shape, double thickness);

/// What keeps two strips apart, for points of each one's edge that faces the other: beside the
/// other's edge, or a thickness above (below) it, and on the way from one to the other on a slope
/// of 45°. Points farther away than the narrower strip is wide are left out.
std::vector<Contact> contacts_of(const StripPair& pair, const FoldedStrip& left,
                                 const FoldedStrip& right, double thickness);

/// The same contacts of strips with every quad divided: each shares its multiplier with the new
/// stations beside it.
std::vector<Contact> subdivided(const std::vector<Contact>& contacts);

/// Whether a contact is another one as strips have moved on.
bool is_same(const Contact& a, const Contact& b);

/// What those contacts lack, mm.
struct Missing {
  double squares = 0.0;  ///< sum of squares, mm²
  double most = 0.0;
};
Missing missing(const StripPair& pair, const FoldedStrip& left, const FoldedStrip& right,
                double thickness);

}  // namespace planish::slit_detail
