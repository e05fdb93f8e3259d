#include "brake/plane_oracle.hpp"

#include "brake/stroke_room.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

using namespace brake_detail;

/// A goose neck, bent towards the operator.
Punch goose_neck() {
  Punch neck = punch();
  neck.id = "G";
  neck.profile = {{0, 0},    {5, 5.96},  {5, 25},   {-12, 45}, {-12, 80}, {14, 100},
                  {14, 150}, {-26, 150}, {-26, 40}, {-8, 18},  {-8, 9.53}};
  return neck;
}

Profile random_profile(std::mt19937& random) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Profile profile;
  profile.thickness = 1.0 + share(random);
  profile.first = 12.0 + 50.0 * share(random);
  const int bends = 2 + static_cast<int>(3.0 * share(random));
  for (int i = 0; i < bends; ++i)
    profile.bends.push_back(
        {Angle::degrees(share(random) < 0.6 ? 90.0 : 30.0 + 60.0 * share(random)),
         1.0 + 2.0 * share(random), share(random) < 0.65, 10.0 + 60.0 * share(random)});
  return profile;
}

/// Both answers on every stage of random strips, for straight and goose-necked punches and both
/// ways to lay the sheet.
TEST(PlaneOracle, AgreesOnEveryStageOfRandomProfiles) {
  std::mt19937 random(2026);
  int clear = 0, blocked = 0, close = 0;
  for (int run = 0; run < 7; ++run) {
    const Profile profile = random_profile(random);
    PlainPunch plain;
    plain.half_width = 6.0 + run % 3 * 4.0;
    PlainDie lower;
    lower.opening = std::round(7.0 * profile.thickness);
    lower.half_width = 0.5 * lower.opening + 6.0 + run % 2 * 8.0;
    BrakeTools tools = plain_tools(plain, lower);
    tools.punches.push_back(goose_neck());
    tools.machine.upper_beam = {{-40, 150}, {40, 150}, {40, 400}, {-40, 400}};
    PlanOptions options;
    options.springback = Angle::degrees(run % 3);
    FlattenOptions flattening;
    flattening.up = run % 2 ? UpSide::reference : UpSide::other;
    Room room(strip(profile.strip(), 60, profile.thickness), tools, options, flattening);
    const int bends = static_cast<int>(profile.bends.size());
    for (int stage = 0; stage < 1 << bends; ++stage) {
      std::vector<int> formed;
      PlaneStroke stroke;
      stroke.springback = options.springback.radians();
      for (int i = 0; i < bends; ++i) {
        stroke.formed.push_back(stage >> i & 1);
        if (stage >> i & 1) formed.push_back(i + 1);
      }
      const LineSet set = room.lines(formed);
      for (const StrokeChoice& choice : choices(room.cache(), set)) {
        const BrakeLine& line = room.work().lines[members(choice.lines).front()];
        stroke.pressed = index_of(line.bends.front());
        const Stroke told = describe(room.cache(), set, choice);
        stroke.gauge_behind = told.to_gauge && index_of(*told.to_gauge) == stroke.pressed + 1;
        const PlaneVerdict verdict = plane_verdict(profile, stroke, tools.punches[choice.punch],
                                                   tools.dies[choice.die],
                                                   tools.machine.upper_beam);
        const bool feasible = check(room.cache(), set, choice).feasible;
        if (verdict == PlaneVerdict::close) {
          ++close;
          continue;
        }
        ++(verdict == PlaneVerdict::clear ? clear : blocked);
        EXPECT_EQ(feasible, verdict == PlaneVerdict::clear)
            << "run " << run << ", stage " << stage << ", bend " << stroke.pressed + 1 << ", punch "
            << choice.punch << ", gauge " << (stroke.gauge_behind ? "behind" : "before");
      }
    }
  }
  EXPECT_GT(clear, 60);
  EXPECT_GT(blocked, 60);
  EXPECT_LT(close, (clear + blocked) / 10);
}

}  // namespace
}  // namespace planish::test
