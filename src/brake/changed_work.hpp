#pragma once

#include "workpiece.hpp"

#include <array>

namespace planish::brake_detail {

/// How much shorter a body can be made, seen from one of its lines, mm; 0 if it cannot: lines on it
/// run across.
double most_shorter(const Workpiece& work, int body, int line);

/// The workpiece with a body shorter by less than `most_shorter`: its far end cut off, or, where
/// other bodies hang on it, a strip taken out beside the line. Straight borders for the gauge stay
/// where the material goes on.
Workpiece shortened(const Workpiece& work, int body, int line, double by);

/// Whether a body beside a line can be made longer: lines on it do not run across.
bool can_lengthen(const Workpiece& work, int body, int line);

/// The workpiece with a strip put into a body, as wide as told, just before a distance from the
/// line; what is farther away moves.
Workpiece lengthened(const Workpiece& work, int body, int line, double at, double by);

/// A body that is changed, and its line towards the bend that is in question.
struct ChangedBody {
  int body = 0, near = 0;
  auto operator<=>(const ChangedBody&) const = default;
};

/// The bodies on the way from one to a line, then all others that do not lie on it.
std::vector<ChangedBody> bodies_to_change(const Workpiece& work, int body, int line);

/// Whether it lies between lines that run the same way.
bool is_web(const Workpiece& work, const ChangedBody& one);

/// The workpiece with a web wider, by a strip in its middle.
Workpiece widened(const Workpiece& work, const ChangedBody& web, double by);

/// The two workpieces that are left when one is cut at a line and what is bent there falls away.
std::array<Workpiece, 2> split_at(const Workpiece& work, int line);

}  // namespace planish::brake_detail
