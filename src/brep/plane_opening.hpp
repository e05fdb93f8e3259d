#pragma once

#include "assembly.hpp"

#include <optional>

namespace planish::brep {

/// An opening between planes, as it lies in the plane of the reference skin.
struct PlaneOpening {
  const RimPart& part;
  LoopRef here, there;
  BorderLoop mine, theirs;
};
PlaneOpening opening_between(const Recognition& of, const RimPart& part, const LoopRef& here,
                             const LoopRef& there, const Frame& plane);

/// Whether a loop is an opening of a plane with nothing but this part along it.
bool goes_round(const Recognition& of, const RimPart& part, const LoopRef& ref);

/// What is cut of an opening: the narrowest section where it is narrower than the skin's outline.
std::optional<BorderLoop> narrower_cut(const Recognition& of, const PlaneOpening& opening,
                                       const Frame& plane);

/// A feature at an opening whose cut begins at `first`.
FormedFeature drawn_opening(const char* kind, FormSide side, const PlaneOpening& opening,
                            const BorderRef& first, std::vector<BorderLoop> outlines);
/// Where an opening is wider than its cut, on either side or on both: to be machined after cutting.
std::vector<FormedFeature> widenings(const PlaneOpening& opening, const BorderRef& first,
                                     const BorderLoop& cut);
/// The same; of one with a thread, where it is wider than that, and the thread.
std::vector<FormedFeature> machined_round(const Recognition& of, const PlaneOpening& opening,
                                          const Frame& plane, const BorderRef& first,
                                          const BorderLoop& cut);

}  // namespace planish::brep
