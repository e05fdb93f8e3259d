// Random plates with pockets, bores and countersinks from both sides, across their edges and each
// other: the blank is what the solid covers, found column by column from what was cut off.
// CONTRIBUTING.md says how it is run.
#include "support/random_run.hpp"
#include "support/unfolded_shape.hpp"

#include <planish/geometry/region.hpp>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp_Explorer.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numeric>
#include <random>

namespace planish::silhouettes {
namespace {

constexpr double kLength = 80.0, kWidth = 60.0;

/// What is cut off: upright, over z from low to high.
struct Cut {
  enum class Kind { box, cylinder, cone } kind = Kind::box;
  double x = 0.0, y = 0.0, low = 0.0, high = 0.0;
  double a = 0.0, b = 0.0;  ///< half sizes; radii at low and high

  TopoDS_Shape shape() const {
    if (kind == Kind::box)
      return BRepPrimAPI_MakeBox({x - a, y - b, low}, {x + a, y + b, high}).Shape();
    const gp_Ax2 axis({x, y, low}, {0, 0, 1});
    if (kind == Kind::cylinder) return BRepPrimAPI_MakeCylinder(axis, a, high - low).Shape();
    return BRepPrimAPI_MakeCone(axis, a, b, high - low).Shape();
  }

  /// The part of a column that it takes; empty: low ≥ high.
  std::pair<double, double> of_column(double px, double py) const {
    constexpr std::pair<double, double> kNothing{0.0, 0.0};
    if (kind == Kind::box)
      return std::abs(px - x) < a && std::abs(py - y) < b ? std::pair(low, high) : kNothing;
    const double r = std::hypot(px - x, py - y);
    if (kind == Kind::cylinder || r < std::min(a, b))
      return r < a || r < std::min(a, b) ? std::pair(low, high) : kNothing;
    if (r >= std::max(a, b)) return kNothing;
    const double at = low + (r - a) / (b - a) * (high - low);
    return a < b ? std::pair(at, high) : std::pair(low, at);
  }

  std::string text() const {
    constexpr std::array kNames{"box", "cylinder", "cone"};
    return fmt::format("{} {:.4f} {:.4f} z {:.4f} to {:.4f}, {:.4f} {:.4f}",
                       kNames[static_cast<int>(kind)], x, y, low, high, a, b);
  }
};

struct Plate {
  double thickness = 0.0;
  std::vector<Cut> cuts;
  TopoDS_Shape shape;

  bool covers(double x, double y) const {
    std::vector<std::pair<double, double>> taken;
    for (const Cut& cut : cuts)
      taken.push_back(cut.of_column(x, y));
    std::ranges::sort(taken);
    double open = 0.0;
    for (const auto& [low, high] : taken)
      if (low <= open + 1e-9) open = std::max(open, high);
    return open < thickness - 1e-9;
  }
};

Cut random_cut(std::mt19937_64& engine, double t) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  Cut cut;
  cut.kind = static_cast<Cut::Kind>(std::uniform_int_distribution<int>(0, 2)(engine));
  cut.x = between(0.0, kLength);
  cut.y = between(0.0, kWidth);
  const double depth = between(0.1, 0.7) * t;
  const int from = std::uniform_int_distribution<int>(0, 2)(engine);  // above, below, through
  cut.low = from == 0 ? t - depth : 0.0;
  cut.high = from == 1 ? depth : t;
  cut.a = between(1.0, 6.0);
  cut.b = between(1.0, 6.0);
  if (cut.kind == Cut::Kind::cone) {
    if (from == 2) cut.kind = Cut::Kind::cylinder;  // a slanted wall is a slanted cut
    cut.b = cut.a;
    (from == 0 ? cut.b : cut.a) += between(0.5, 1.5) * depth;
  }
  return cut;
}

/// Whether the kernel took all cuts off: it forgets one now and then.
bool is_cut(const Plate& plate) {
  BRepClass3d_SolidClassifier where(plate.shape);
  return std::ranges::all_of(plate.cuts, [&](const Cut& cut) {
    where.Perform({cut.x, cut.y, std::midpoint(cut.low, cut.high)}, 1e-7);
    return where.State() != TopAbs_IN;
  });
}

Plate random_plate(std::uint64_t seed, int index) {
  std::mt19937_64 engine(seed * 1000003 + static_cast<std::uint64_t>(index));
  Plate plate;
  plate.thickness = std::uniform_real_distribution<double>(1.0, 6.0)(engine);
  plate.shape = BRepPrimAPI_MakeBox({0, 0, 0}, {kLength, kWidth, plate.thickness}).Shape();
  const int count = std::uniform_int_distribution<int>(1, 6)(engine);
  for (int i = 0; i < count; ++i) {
    plate.cuts.push_back(random_cut(engine, plate.thickness));
    plate.shape = BRepAlgoAPI_Cut(plate.shape, plate.cuts.back().shape()).Shape();
  }
  TopExp_Explorer solids(plate.shape, TopAbs_SOLID);
  if (!solids.More() || !BRepCheck_Analyzer(plate.shape).IsValid()) return {};
  plate.shape = solids.Current();
  solids.Next();
  return solids.More() || !is_cut(plate) ? Plate{} : plate;
}

/// Columns that the pattern has and the solid does not cover, or the other way round.
std::string wrong_columns(const Plate& plate, const Sheet& sheet) {
  constexpr double kStep = 0.5, kNear = 0.02;  // mm
  const Face& face = sheet.faces.front();
  const auto& frame = std::get<Frame>(face.surface);
  std::vector<std::vector<Vec2>> rings;
  std::vector<Curve2> curves;
  for (const BorderLoop& loop : face.loops) {
    if (loop.front().feature) continue;  // drawn, and not cut
    const Loop drawn = mapped(loop, &Border::curve);
    rings.push_back(sampled(drawn, 1e-4));
    curves.insert(curves.end(), drawn.begin(), drawn.end());
  }
  for (double x = 0.13; x < kLength; x += kStep)
    for (double y = 0.17; y < kWidth; y += kStep) {
      const bool covered = plate.covers(x, y);
      const Vec2 p = frame.local2({x, y, 0.0});
      if (inside(rings, p) == covered) continue;
      const bool near = std::ranges::any_of(
          curves, [&](const Curve2& curve) { return nearest(curve, p).distance < kNear; });
      if (!near)
        return fmt::format("at ({}, {}) the solid {}", x, y,
                           covered ? "is not in the pattern" : "is open, and the pattern is not");
    }
  return {};
}

struct Verdict {
  bool refused = false;
  std::string wrong;
};

Verdict verdict_on(const Plate& plate, const std::string& text) {
  const auto made = test::unfolded_sheet(test::recognized_text(text));
  if (!made) return {true, made.error().message};
  if (auto wrong = wrong_columns(plate, made->sheet); !wrong.empty()) return {false, wrong};
  const Certificate* certificate = &made->certificate;
  constexpr double kOff = 1e-6;  // mm
  for (const auto& [name, off] : {std::pair("opening_error", certificate->opening_error),
                                  std::pair("outline_error", certificate->outline_error)})
    if (off.value_or(0.0) > kOff) return {false, fmt::format("{} is {}", name, *off)};
  // Curves that are no lines or arcs are fitted this closely.
  constexpr double kFitted = 1e-5, kMeasured = 1e-8;  // mm; of the area
  double fitted = 0.0;
  for (const BorderLoop& loop : made->sheet.faces.front().loops)
    for (const Border& border : loop)
      if (std::holds_alternative<CubicSpline>(border.curve)) fitted += length(border.curve);
  const double bound = kMeasured + kFitted * fitted / made->flat.area;
  if (std::abs(certificate->explained_ratio.value_or(0.0) - 1.0) > bound)
    return {false, fmt::format("explained_ratio is {}", certificate->explained_ratio.value_or(0))};
  return {};
}

int run(const test::RandomRun& options) {
  int defects = 0, unmade = 0, refused = 0;
  for (int i = options.first; i < options.first + options.count; ++i) {
    Plate plate;
    const auto text = brep::guarded([&] {
      plate = random_plate(options.seed, i);
      return plate.shape.IsNull() ? std::string() : brep::step_text(plate.shape, "plate").value();
    });
    if (!text || text->empty()) {
      ++unmade;
      continue;
    }
    const auto said = brep::guarded([&] { return verdict_on(plate, *text); });
    const Verdict verdict = said ? *said : Verdict{false, said.error().message};
    refused += verdict.refused ? 1 : 0;
    if (verdict.wrong.empty() && !options.list) continue;
    defects += verdict.refused || verdict.wrong.empty() ? 0 : 1;
    if (!options.keep.empty())
      std::ofstream(fmt::format("{}/plate_{}_{}.step", options.keep, options.seed, i)) << *text;
    fmt::print("{} of {:.4f} mm{}: {}\n", i, plate.thickness, verdict.refused ? ", refused" : "",
               verdict.wrong);
    if (verdict.refused && !options.list) continue;
    for (const Cut& cut : plate.cuts)
      fmt::print("  {}\n", cut.text());
    std::fflush(stdout);
  }
  fmt::print("{} plates, {} could not be made, {} refused, {} defects\n", options.count, unmade,
             refused, defects);
  constexpr double kMostRefused = 0.1;  // milled all over
  return defects == 0 && refused <= kMostRefused * options.count ? 0 : 1;
}

}  // namespace
}  // namespace planish::silhouettes

int main(int argc, char** argv) {
  const auto options = planish::test::random_run({argv + 1, argv + argc}, 40);
  if (options) return planish::silhouettes::run(*options);
  fmt::print(stderr, "random_silhouettes {}\n", planish::test::kRandomRunUsage);
  return 2;
}
