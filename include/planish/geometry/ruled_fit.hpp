#pragma once

#include <planish/geometry/developable.hpp>

#include <functional>
#include <vector>

namespace planish {

/// One ruling of a developable, with its derivatives by u, and how far the surface reaches along it
/// (mm, signed as v).
struct Ruling {
  Ruled::Knot knot;
  double reach = 0.0;
};

/// The developable through given rulings, from the first to the last of `breaks` (growing; a knot
/// is placed at each, so list the places where the rulings are less smooth). Accuracy: points at v
/// = 0 and at the reach are within `tolerance` (mm) of the intended surface's points at the same
/// (u, v); normals are within (tolerance / s)^¾ radians, s the largest reach. Knots are placed by
/// halving, 4096 intervals at most between two breaks; below about 1e-13 s rounding limits the
/// accuracy. Requires: tolerance > 0; b′ nowhere along g. Cost: about 10 rulings per interval;
/// intervals grow with (s / tolerance)^¼.
Ruled ruled_through(const std::function<Ruling(double)>& ruling, const std::vector<double>& breaks,
                    double tolerance);

}  // namespace planish
