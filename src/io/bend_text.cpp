#include "bend_text.hpp"

#include "svg_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace planish::io_detail {

std::string bend_text(const FlatBend& bend) {
  const std::string stroke = bend.stroke ? fmt::format("{}: ", *bend.stroke) : "";
  // Words, not arrows: an arrow turned with its line no longer points up or down.
  const std::string head = fmt::format("{}{} {}", stroke, bend.id,
                                       bend.direction == BendDirection::up ? "UP" : "DOWN");
  const bool pressed = bend.line_angles.size() > 1 && bend.line_angles.front() < bend.angle;
  if (!pressed)
    return fmt::format("{} {}° R{}", head, svg_number(bend.angle.degrees(), 2),
                       svg_number(bend.inside_radius, 2));
  const auto [least, most] = std::ranges::minmax(bend.line_angles);
  const std::string from = svg_number(least.degrees(), 2), to = svg_number(most.degrees(), 2);
  return fmt::format("{} {} × {}°", head, bend.line_angles.size(),
                     from == to ? from : from + " … " + to);
}

}  // namespace planish::io_detail
