// Random plates and brackets: every opening of the pattern is the narrowest of the kernel's own
// sections, and one that is falsified is noticed. CONTRIBUTING.md says how it is run.
#include "random_part.hpp"
#include "sections.hpp"
#include "support/random_run.hpp"
#include "support/unfolded_shape.hpp"

#include <planish/geometry/region.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>

namespace planish::openings {
namespace {

using Options = test::RandomRun;

constexpr double kWidth = 1e-6;   // mm: within which outlines agree, all round
constexpr double kKernel = 2e-5;  // mm: to which the kernel's sections of roundings are good

/// Areas of an opening's sections: the least of all, and half-way up its land.
struct Least {
  double area = HUGE_VAL, at_land = HUGE_VAL;
};

constexpr int kDepths = 50;

/// The narrowest section of each opening, of 50 heights; every one with a land has one in it.
std::vector<Least> narrowest(const Part& part) {
  std::vector<Least> least(part.openings.size());
  for (int f = 0; f < std::ssize(part.flanges); ++f) {
    std::vector<double> heights;
    for (const Opening& opening : part.openings)
      if (opening.flange == f && opening.land) heights.push_back(opening.depth);
    while (std::ssize(heights) < kDepths)
      heights.push_back(part.thickness * (static_cast<double>(heights.size()) + 0.37) / kDepths);
    for (const SectionWire& wire : sections(part.shape, part.flanges[f], heights)) {
      if (wire.outer) continue;
      for (std::size_t i = 0; i < part.openings.size(); ++i) {
        const Opening& opening = part.openings[i];
        if (opening.flange != f || std::hypot(wire.x - opening.x, wire.y - opening.y) > 1.0)
          continue;
        least[i].area = std::min(least[i].area, wire.area);
        constexpr double kSameHeight = 1e-9;
        if (std::abs(wire.height - opening.depth) < kSameHeight) least[i].at_land = wire.area;
      }
    }
  }
  return least;
}

bool is_same(const Loop& loop, const Opening& opening) {
  return std::abs(-signed_area(loop) - opening.area) <= kWidth * opening.perimeter &&
         std::abs(length(loop) - opening.perimeter) <= 2 * std::numbers::pi * kWidth;
}

/// The kernel's sections against the opening as it was designed.
std::string wrong_sections(const Part& part) {
  const std::vector<Least> sections = narrowest(part);
  for (std::size_t i = 0; i < part.openings.size(); ++i) {
    const Opening& opening = part.openings[i];
    const auto off = [&](double area) { return (area - opening.area) / opening.perimeter; };
    if (!(off(sections[i].area) >= -kKernel) ||
        (opening.land && !(std::abs(off(sections[i].at_land)) <= kWidth)))
      return fmt::format("the kernel's sections of ({}) are {} and {} mm wider", opening.how,
                         off(sections[i].area), off(sections[i].at_land));
  }
  return {};
}

/// Openings of the pattern and of the part that have no equal in the other.
std::string wrong_openings(const FlatPattern& flat, const Part& part) {
  if (flat.openings.size() != part.openings.size())
    return fmt::format("{} openings, not {}", flat.openings.size(), part.openings.size());
  std::vector<Contour> left = flat.openings;
  std::string wrong;
  for (const Opening& opening : part.openings) {
    const auto found = std::ranges::find_if(
        left, [&](const Contour& contour) { return is_same(contour.loop, opening); });
    if (found != left.end())
      left.erase(found);
    else
      wrong += fmt::format("no ({}) of {}; ", opening.how, opening.area);
  }
  for (const Contour& contour : left)
    wrong += fmt::format("an opening of {}; ", -signed_area(contour.loop));
  return wrong;
}

std::string wrong_outline(const FlatPattern& flat, const Part& part) {
  const double off = (signed_area(flat.outer.loop) - part.blank_area) / length(flat.outer.loop);
  const double longer = length(flat.outer.loop) - part.blank_perimeter;
  if (!flat.slits.empty()) return fmt::format("{} slits", flat.slits.size());
  if (std::abs(off) <= kWidth && std::abs(longer) <= 2 * std::numbers::pi * kWidth) return {};
  return fmt::format("the outline is {:.6f} mm too wide and {:.6f} mm too long", off, longer);
}

/// An opening drawn 0.2 mm larger or smaller about its middle.
std::string unnoticed(const Sheet& sheet, const FlatPattern& flat) {
  for (std::size_t i = 0; i < flat.openings.size(); ++i)
    for (const double by : {-0.2, 0.2}) {
      FlatPattern wrong = flat;
      const Box2 box = bounds(flat.openings[i].loop);
      const double factor = 1.0 + by / box.size().maxCoeff();
      Loop& loop = wrong.openings[i].loop;
      loop = scaled(loop, factor, (box.lo + box.hi) / 2);
      const auto certificate = certify(sheet, wrong, {});
      if (!certificate || certificate->opening_error.value_or(0.0) < 0.02)
        return fmt::format("an opening wrong by {} mm is not noticed", by);
    }
  return {};
}

/// What is wrong about a part's pattern; empty: nothing.
std::string wrong_with(const Part& part, const std::string& text) {
  const auto made = test::unfolded_sheet(test::recognized_text(text));
  if (!made) return "refused: " + made.error().message;
  const FlatPattern& flat = made->flat;
  for (auto wrong : {wrong_sections(part), wrong_openings(flat, part), wrong_outline(flat, part)})
    if (!wrong.empty()) return wrong;
  const Certificate* certificate = &made->certificate;
  if (const double off = certificate->opening_error.value_or(0.0); off > kWidth)
    return fmt::format("opening_error is {}", off);
  if (certificate->explained_ratio && std::abs(*certificate->explained_ratio - 1.0) > 1e-8)
    return fmt::format("explained_ratio is {}", *certificate->explained_ratio);
  if (const double off = certificate->refold_deviation.value_or(0.0); off > 1e-4)
    return fmt::format("refold_deviation is {}", off);
  return unnoticed(made->sheet, flat);
}

int run(const Options& options) {
  int defects = 0, unmade = 0, openings = 0;
  for (int i = options.first; i < options.first + options.count; ++i) {
    Part part;
    const auto text = brep::guarded([&] {
      part = random_part(options.seed, i);
      return part.shape.IsNull() ? std::string() : brep::step_text(part.shape, "part").value();
    });
    if (!text || text->empty()) {
      ++unmade;
      continue;
    }
    openings += static_cast<int>(part.openings.size());
    const auto said = brep::guarded([&] { return wrong_with(part, *text); });
    const std::string wrong = said ? *said : said.error().message;
    if (!options.keep.empty() && (!wrong.empty() || options.list))
      std::ofstream(fmt::format("{}/openings_{}_{}.step", options.keep, options.seed, i)) << *text;
    if (options.list) {
      fmt::print("{}: {} of {} mm\n", i, part.how, part.thickness);
      for (const Opening& opening : part.openings)
        fmt::print("  ({}, {}) of flange {}: {}, area {}\n", opening.x, opening.y, opening.flange,
                   opening.how, opening.area);
    }
    if (wrong.empty()) continue;
    ++defects;
    fmt::print("{} ({}): {}\n", i, part.how, wrong);
    std::fflush(stdout);
  }
  fmt::print("{} parts, {} openings, {} the kernel could not make, {} defects\n", options.count,
             openings, unmade, defects);
  return defects == 0 ? 0 : 1;
}

}  // namespace
}  // namespace planish::openings

int main(int argc, char** argv) {
  const auto options = planish::test::random_run({argv + 1, argv + argc}, 40);
  if (options) return planish::openings::run(*options);
  fmt::print(stderr, "random_openings {}\n", planish::test::kRandomRunUsage);
  return 2;
}
