#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace planish::io_detail {

/// At most `decimals` digits after the point, without trailing zeros or a negative zero.
std::string svg_number(double value, int decimals = 5);

/// Text between tags or in an attribute, without control characters, which XML 1.0 cannot hold.
std::string xml_escaped(std::string_view text);

/// "x y" with y turned to point down.
std::string svg_point(const Vec2& p);

/// Path data ("M … Z") of a closed loop: lines, arcs (a full circle as two) and cubics as they are.
std::string svg_path(const Loop& loop);
/// The same of a curve that is not closed.
std::string svg_open_path(const Curve2& curve);

/// The bend zone as quadrilaterals between the tangent lines on its two sides, corner by corner.
/// May cover openings; clip with the contours.
std::vector<std::array<Vec2, 4>> bend_zones(const FlatBend& bend);

}  // namespace planish::io_detail
