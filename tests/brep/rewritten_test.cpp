#include "body.hpp"
#include "guarded.hpp"
#include "step_out.hpp"
#include "support/real_parts.hpp"

#include <planish/brep/step.hpp>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <ShapeCustom.hxx>
#include <ShapeFix_Shape.hxx>
#include <ShapeUpgrade_ShapeDivideAngle.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>

// The same part as other systems would write it has the same flat pattern: surfaces and curves as
// splines or revolutions, faces split at every 30°, the part mirrored, turned and far away.

namespace planish::test {
namespace {

namespace fs = std::filesystem;
using Rewrite = std::function<TopoDS_Shape(const TopoDS_Shape&)>;

const fs::path kParts = real_parts_folder();

struct Laid {
  Sheet sheet;
  FlatPattern flat;
  double explained = 0.0;
};

Result<Laid> lay(const Body& body) {
  auto found = recognize(body);
  if (!found) return tl::unexpected(found.error());
  auto flat = flatten(found->sheet);
  if (!flat) return tl::unexpected(flat.error());
  const auto certificate = certify(found->sheet, *flat, found->distance);
  if (!certificate) return tl::unexpected(certificate.error());
  return Laid{std::move(found->sheet), std::move(*flat),
              certificate->explained_ratio.value_or(std::nan(""))};
}

/// With all that the kernel's tools expect of a shape: what is read here is not mended.
TopoDS_Shape mended_by_kernel(const TopoDS_Shape& shape) {
  ShapeFix_Shape mending(BRepBuilderAPI_Copy(shape).Shape());
  mending.Perform();
  return mending.Shape();
}

Result<Laid> lay_rewritten(const Body& body, const Rewrite& rewrite) {
  const auto text = brep::guarded(
      [&] { return brep::step_text(rewrite(mended_by_kernel(body.shape().solid)), "rewritten"); });
  if (!text) return tl::unexpected(text.error());
  const auto file = read_step_text(*text, "rewritten.step");
  if (!file) return tl::unexpected(file.error());
  return lay(file->bodies.front());
}

double perimeter(const FlatPattern& flat) {
  double sum = length(flat.outer.loop);
  for (const Contour& opening : flat.openings)
    sum += length(opening.loop);
  return sum;
}

/// A handful of real sheets of all kinds, none so large that rewriting it takes long.
std::vector<fs::path> some_parts() {
  std::vector<fs::path> parts;
  constexpr uintmax_t kLargest = 600'000;  // bytes
  for (const auto& entry : fs::directory_iterator(kParts)) {
    const std::string name = entry.path().filename();
    if (entry.path().extension() == ".step" &&
        (name.starts_with("sm") || name.starts_with("sharp")) && entry.file_size() < kLargest)
      parts.push_back(entry.path());
  }
  std::ranges::sort(parts);
  constexpr size_t kEvery = 6;
  std::vector<fs::path> chosen;
  for (size_t i = 0; i < parts.size(); i += kEvery)
    chosen.push_back(parts[i]);
  return chosen;
}

class Rewritten : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(kParts)) GTEST_SKIP() << kNoRealParts;
  }

  static void keeps_patterns(const Rewrite& rewrite) {
    int compared = 0;
    for (const fs::path& part : some_parts()) {
      SCOPED_TRACE(part.filename());
      const auto file = read_step(part);
      if (!file || file->bodies.size() != 1) continue;
      const auto as_is = lay(file->bodies.front());
      if (!as_is) continue;  // refusals are the corpus test's
      const auto again = lay_rewritten(file->bodies.front(), rewrite);
      if (!again) {
        ADD_FAILURE() << again.error().message;
        continue;
      }
      ++compared;
      const double extent = std::sqrt(as_is->flat.area);
      EXPECT_NEAR(again->sheet.thickness, as_is->sheet.thickness, 1e-4 * as_is->sheet.thickness);
      EXPECT_EQ(again->flat.bends.size(), as_is->flat.bends.size());
      // Where cuts are not normal to the sheet, which skin the pattern is drawn from decides.
      const double slanted = std::isfinite(as_is->explained) ? std::abs(as_is->explained - 1)
                                                             : 1e-3;
      EXPECT_NEAR(again->flat.area, as_is->flat.area, (1e-5 + 2 * slanted) * as_is->flat.area);
      EXPECT_NEAR(perimeter(again->flat), perimeter(as_is->flat),
                  1e-4 * perimeter(as_is->flat) + 1e-4 * extent);
    }
    EXPECT_GT(compared, 5);
  }
};

TEST_F(Rewritten, WithEverythingAsSplines) {
  keeps_patterns(
      [](const TopoDS_Shape& shape) { return BRepBuilderAPI_NurbsConvert(shape, true).Shape(); });
}

TEST_F(Rewritten, WithSurfacesOfRevolution) {
  keeps_patterns([](const TopoDS_Shape& shape) { return ShapeCustom::ConvertToRevolution(shape); });
}

TEST_F(Rewritten, WithFacesSplitByAngle) {
  keeps_patterns([](const TopoDS_Shape& shape) {
    ShapeUpgrade_ShapeDivideAngle split(0.5, shape);
    split.Perform();
    return split.Result();
  });
}

TEST_F(Rewritten, MirroredTurnedAndFarAway) {
  keeps_patterns([](const TopoDS_Shape& shape) {
    gp_Trsf mirror, turn, move;
    mirror.SetMirror(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(1, 2, -0.3)));
    turn.SetRotation(gp_Ax1(gp_Pnt(10, -33, 7), gp_Dir(1, 2, -0.3)), 1.234);
    move.SetTranslation(gp_Vec(5321.7, -1234.5, 877.77));
    return BRepBuilderAPI_Transform(shape, move * turn * mirror, true).Shape();
  });
}

}  // namespace
}  // namespace planish::test
