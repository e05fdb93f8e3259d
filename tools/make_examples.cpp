// Writes examples/bracket.step: the part that the quickstart unfolds. Run it with the folder to
// write to. It is made by the test builders in closed form, so that its flat pattern is known: see
// the README.

#include "support/sheet_builder.hpp"

#include <planish/brep/step.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>

using namespace planish;
using namespace planish::test;

namespace {

/// A flange behind a rim of length `width`: straight sides, far corners rounded.
Loop rounded_tab(double width, double height, double radius) {
  constexpr double quarter = std::numbers::pi / 2;
  return {Segment{{0, 0}, {width, 0}},
          Segment{{width, 0}, {width, height - radius}},
          Arc{{width - radius, height - radius}, radius, 0, quarter},
          Segment{{width - radius, height}, {radius, height}},
          Arc{{radius, height - radius}, radius, quarter, quarter},
          Segment{{0, height - radius}, {0, 0}}};
}

/// Base 80 × 50 of 2 mm sheet with bend reliefs; a long flange up with two Ø6.6 holes, a
/// short one up by 60°, a slot in the base.
Sheet bracket() {
  constexpr double thickness = 2.0;
  const std::vector<Vec2> corners{{0, 0},   {80, 0},    {80, 5.5},  {74, 5.5},  {74, 8},
                                  {80, 8},  {80, 40},   {74, 40},   {74, 42.5}, {80, 42.5},
                                  {80, 50}, {70.5, 50}, {70.5, 44}, {68, 44},   {68, 50},
                                  {12, 50}, {12, 44},   {9.5, 44},  {9.5, 50},  {0, 50}};
  SheetBuilder builder(thickness);
  const FaceId base = builder.flange(
      Frame{}, {polygon(corners), obround_opening({40, 22}, 20, 4, Angle::degrees(0))});
  const Rim long_side = builder.bend(builder.rim(base, 14),
                                     Turn{Angle::degrees(90), 2.5, BendDirection::up});
  builder.flange_behind(long_side, {rounded_tab(56, 30, 6), circular_opening({12, 16}, 3.3),
                                    circular_opening({44, 16}, 3.3)});
  const Rim short_side = builder.bend(builder.rim(base, 5),
                                      Turn{Angle::degrees(60), 3.0, BendDirection::up});
  builder.flange_behind(short_side, {rounded_tab(32, 20, 4)});
  return builder.finish();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_examples FOLDER\n", stderr);
    return 2;
  }
  const auto text = folded_solid_step(bracket(), "bracket");
  if (!text) {
    std::fprintf(stderr, "make_examples: %s\n", text.error().message.c_str());
    return 1;
  }
  std::ofstream(std::filesystem::path(argv[1]) / "bracket.step", std::ios::binary) << *text;
  return 0;
}
