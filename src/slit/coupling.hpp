#pragma once

#include "strip_system.hpp"

#include <array>
#include <vector>

namespace planish::slit_detail {

/// Bonds between the middles of corresponding ridges of all strips of a system, each beside the
/// next: weighed as wishes are, the mean of some ridges, so that subdivision does not change it.
std::vector<Bond> bonds_of(const std::vector<StripProblem>& strips, double weight);

/// What keeps the gap where they end from being less or more: contacts in its present direction.
std::vector<Contact> kept_gap(int left, int right, const FoldedStrip& of_left,
                              const FoldedStrip& of_right, const std::array<double, 2>& gap);

/// A gap on the way from what it is to what it should be.
std::array<double, 2> on_the_way(const std::array<double, 2>& gap, double now, double share);

/// By how much the gaps of strips are beyond these limits, at most.
double gap_missed(const std::vector<FoldedStrip>& strips, const std::array<double, 2>& gap);

}  // namespace planish::slit_detail
