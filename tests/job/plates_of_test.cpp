#include "job/job_requests.hpp"
#include "support/sheets.hpp"

#include <planish/job/plates_json.hpp>
#include <planish/job/plates_of.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::job {
namespace {

using namespace planish::test;

TEST(PlatesOf, StandOnTheMiddleSurface) {
  // 50 | 90° up r 3 | 30, width 40, t 2; the reference skin of the first flange at z = 0.
  const Sheet sheet = l_bracket();
  const PlateStructure plates = plates_of(sheet);
  EXPECT_EQ(plates.thickness, 2.0);
  ASSERT_EQ(plates.plates.size(), 2u);
  EXPECT_TRUE(plates.bends.empty()) << "unless asked";
  EXPECT_EQ(plates.plates[0].id, "1");
  EXPECT_EQ(plates.plates[1].id, "2");
  const double middle = sheet.reference_depth - 1.0;
  ASSERT_EQ(plates.plates[0].outline.size(), 4u);
  for (const Vec3& p : plates.plates[0].outline)
    EXPECT_NEAR(p.z(), middle, 1e-12);
  double length = 0.0;
  for (std::size_t i = 0; i < 4; ++i)
    length += (plates.plates[1].outline[(i + 1) % 4] - plates.plates[1].outline[i]).norm();
  EXPECT_NEAR(length, 2 * (30.0 + 40.0), 1e-9) << "up to the bend";
}

TEST(PlatesOf, SayWhichPlatesBendsJoin) {
  const PlateStructure plates = plates_of(u_channel(), {.with_bends = true});
  ASSERT_EQ(plates.bends.size(), 2u);
  for (const BendRequest& bend : plates.bends) {
    ASSERT_EQ(bend.between.size(), 2u);
    EXPECT_NE(bend.between[0], bend.between[1]);
    EXPECT_EQ(bend.inside_radius, 2.0);
  }
  const PlateStructure cone = plates_of(cone_joined(), {.with_bends = true});
  ASSERT_EQ(cone.bends.size(), 1u);
  EXPECT_FALSE(cone.bends[0].inside_radius) << "it differs along a cone";
}

TEST(PlatesOf, HaveRoundOutlinesWithoutCornersTooNear) {
  SheetBuilder builder(2.0);
  const Loop disc{Arc{{50, 30}, 10.0, 0.0, 2.0 * std::numbers::pi}};
  builder.flange(Frame{}, std::vector<Loop>{disc});
  const Sheet sheet = builder.finish();
  for (const double chord : {0.01, 1.0}) {
    const PlateStructure plates = plates_of(sheet, {.chord = chord});
    const auto& ring = plates.plates[0].outline;
    double area = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec3 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      EXPECT_NEAR((a.head<2>() - Vec2(50, 30)).norm(), 10.0, 1e-9);
      EXPECT_GT((b - a).norm(), chord);
      area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    EXPECT_LE(std::abs(area), std::numbers::pi * 100);
    EXPECT_GE(std::abs(area), std::numbers::pi * 100 - 2 * std::numbers::pi * 10 * chord);
  }
}

TEST(PlatesOf, HaveCirclesSlotsAndArcsAsTheyAre) {
  const double pi = std::numbers::pi;
  SheetBuilder builder(2.0);
  const Loop hole{Arc{{30, 30}, 10.0, 0.0, -2.0 * pi}};
  const Loop slot{Segment{{60, 35}, {80, 35}}, Arc{{80, 30}, 5.0, 0.5 * pi, -pi},
                  Segment{{80, 25}, {60, 25}}, Arc{{60, 30}, 5.0, -0.5 * pi, -pi}};
  const Loop half{Arc{{50, 10}, 6.0, pi, -pi}, Segment{{56, 10}, {44, 10}}};
  builder.flange(Frame{}, {rectangle(100, 60), hole, slot, half});
  const PlateStructure plates = plates_of(builder.finish());
  const Plate& plate = plates.plates[0];
  ASSERT_EQ(plate.holes.size(), 3u);
  const auto& circle = std::get<RoundHole>(plate.shapes.at(0));
  EXPECT_LT((circle.at.head<2>() - Vec2(30, 30)).norm(), 1e-12);
  EXPECT_EQ(circle.radius, 10.0);
  EXPECT_EQ(std::get<SlotHole>(plate.shapes.at(1)).width, 10.0);
  const auto& path = std::get<ArcHole>(plate.shapes.at(2));
  ASSERT_TRUE(path.through[0] && !path.through[1]);
  EXPECT_LT((path.through[0]->head<2>() - Vec2(50, 16)).norm(), 1e-9);
  // And back from the file.
  const auto read = parse_plates(plates_text(plates), "p.json");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->structure.plates[0].shapes.size(), 3u);
  EXPECT_EQ(std::get<ArcHole>(read->structure.plates[0].shapes.at(2)).corners.size(), 2u);
}

TEST(PlatesOf, AreAFileThatIsReadAgain) {
  PlateStructure plates = plates_of(u_channel(), {.with_bends = true});
  plates.plates[0].outline[0] = Vec3(-1e-9, 1.0 / 3.0, -2.5);
  plates.plates[0].holes = {{{1, 2, 0}, {3, 2, 0}, {3, 4, 0}}};
  const std::string text = plates_text(plates);
  const auto read = parse_plates(text, "p.json");
  ASSERT_TRUE(read) << read.error().message << " at " << read.error().where;
  EXPECT_EQ(read->units, LengthUnit::mm);
  EXPECT_EQ(read->structure.thickness, plates.thickness);
  ASSERT_EQ(read->structure.plates.size(), plates.plates.size());
  for (std::size_t p = 0; p < plates.plates.size(); ++p) {
    EXPECT_EQ(read->structure.plates[p].id, plates.plates[p].id);
    ASSERT_EQ(read->structure.plates[p].outline.size(), plates.plates[p].outline.size());
    for (std::size_t i = 0; i < plates.plates[p].outline.size(); ++i)
      EXPECT_LT((read->structure.plates[p].outline[i] - plates.plates[p].outline[i]).norm(), 1e-6);
  }
  EXPECT_EQ(read->structure.plates[0].holes, plates.plates[0].holes);
  ASSERT_EQ(read->structure.bends.size(), 2u);
  EXPECT_EQ(read->structure.bends[1].between, plates.bends[1].between);
  EXPECT_EQ(read->structure.bends[1].inside_radius, 2.0);
  EXPECT_EQ(text.find("-0.0,"), std::string::npos);
  EXPECT_NE(text.find("0.333333,"), std::string::npos) << "to a millionth";
}

}  // namespace
}  // namespace planish::job
