#pragma once

#include "triangle.hpp"

#include <vector>

namespace planish::collision_detail {

/// Points just below both triangles, where they meet: `aside` below the plane of each, at places
/// along the segment in which the triangles cross, or in the middle of the area by which they cover
/// each other, looking the same way, at most `reach` apart and over a width of about half of it.
/// Empty where they do not meet, where they look at each other (skins that touch), where one lies
/// wholly outside the other's plane, and for neighbours in a mesh. A surface that runs through
/// itself has such a point that it encloses twice; whether one is, the triangles alone do not say.
std::vector<Vec3> points_below_both(const Triangle& a, const Triangle& b, double aside,
                                    double reach);

/// How many corners of two triangles are at the same places.
int shared_corners(const Triangle& a, const Triangle& b);

}  // namespace planish::collision_detail
