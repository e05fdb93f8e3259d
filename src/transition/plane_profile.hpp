#pragma once

#include "plane_element.hpp"

#include <planish/base/result.hpp>

#include <string>
#include <vector>

namespace planish::transition_detail {

/// The elements of a profile in its own plane, set `outwards` (mm, negative: inwards), run
/// counter-clockwise: edges of polygons, and parts of curves that turn by at most 90°. Corners of
/// polygons stay corners. `pointer` is the profile's place in the request. Errors: those of
/// `make_transition` for one profile.
Result<std::vector<PlaneElement>> elements_of(const Profile& profile, double outwards,
                                              const std::string& pointer);

}  // namespace planish::transition_detail
