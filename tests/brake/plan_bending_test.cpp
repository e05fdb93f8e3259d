#include "brake/stroke_room.hpp"

#include <planish/brake/codes.hpp>

#include <gtest/gtest.h>

#include <chrono>
#include <numbers>

namespace planish::test {
namespace {

const double kSine45 = std::numbers::sqrt2 / 2.0;

Turn turn_up(double angle = 90.0, double radius = 2.0) {
  return {Angle::degrees(angle), radius, BendDirection::up};
}

Result<Plan> plan_of(const Sheet& sheet, const BrakeTools& tools, const PlanOptions& options = {},
                     const FlattenOptions& flattening = {}) {
  const auto flat = flat_sheet(sheet, flattening);
  EXPECT_TRUE(flat);
  return plan_bending(sheet, flat->layout, tools, options);
}

/// A U whose first leg only closes if it is bent last: the plan bends it last.
TEST(PlanBending, BendsTheLongLegLast) {
  const double longest = 60.0 + 2.0 - (10.0 - 0.05) / kSine45;  // check_test.cpp
  const Sheet sheet = strip(
      {Straight{longest + 5}, turn_up(), Straight{60}, turn_up(), Straight{30}}, 80, 1.5);
  const auto plan = plan_of(sheet, plain_tools());
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->status, PlanStatus::optimal);
  ASSERT_EQ(plan->strokes.size(), 2u);
  EXPECT_EQ(plan->strokes[0].bends, std::vector<BendId>{BendId(1)});
  EXPECT_EQ(plan->strokes[1].bends, std::vector<BendId>{BendId(0)});
}

/// Both legs too long: proven, and told how deep in the punch the leg is, and when. A leg δ beyond
/// the limit comes δ sin 45° deeper than the ε that is allowed, at the end of the stroke.
TEST(PlanBending, ProvesThatALegHitsThePunch) {
  const double longest = 60.0 + 2.0 - (10.0 - 0.05) / kSine45, beyond = 3.0;
  const Sheet sheet = strip(
      {Straight{longest + beyond}, turn_up(), Straight{60}, turn_up(), Straight{longest + beyond}},
      80, 1.5);
  const auto plan = plan_of(sheet, plain_tools());
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->status, PlanStatus::infeasible);
  EXPECT_TRUE(plan->strokes.empty());
  EXPECT_EQ(plan->unformed.size(), 1u);
  ASSERT_FALSE(plan->remarks.empty());
  EXPECT_EQ(plan->remarks.back().code, kFurthestStage);
  ASSERT_FALSE(plan->in_the_way.empty());
  EXPECT_EQ(plan->remarks.back().told.places.front(),
            place::bend("B" + std::to_string(index_of(plan->in_the_way.back().bend) + 1)));
  EXPECT_EQ(plan->remarks.back().told.places.back().kind, PlaceKind::flange);
  Room room(sheet, plain_tools());
  const BlockedBend blocked = brake_detail::blocked(room.cache(), room.lines({1}), room.line_of(2));
  EXPECT_EQ(blocked.hits, (ToolName{ToolKind::punch, "P"}));
  EXPECT_EQ(blocked.with, FlangeId(0));
  EXPECT_NEAR(blocked.depth, 0.05 + beyond * kSine45, 0.01);
  ASSERT_TRUE(blocked.at_turn);
  EXPECT_NEAR(blocked.at_turn->degrees(), 90.0, 0.5);
}

TEST(PlanBending, BendsHatZAndBox) {
  for (const Sheet& sheet :
       {z_profile(), box(), box({}, BendDirection::down), l_bracket(), l_bracket_down()}) {
    BrakeTools tools = plain_tools({},
                                   {10.0, Angle::degrees(80), 1.0, 9.0, 100.0, {300, 50, 20, 10}});
    const auto plan = plan_of(sheet, tools);
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(plan->status, PlanStatus::optimal);
    EXPECT_EQ(plan->strokes.size(), sheet.bends.size());
  }
}

TEST(PlanBending, SaysWhichToolIsMissing) {
  const auto code = [](const Sheet& sheet, const BrakeTools& tools,
                       const PlanOptions& options = {}) {
    const auto plan = plan_of(sheet, tools, options);
    return plan ? "" : std::string(code_name(plan.error().code));
  };
  BrakeTools blunt = plain_tools();
  PlanOptions drawn;
  drawn.radius = RadiusWanted::drawn;
  for (const VChoice v : {VChoice::any, VChoice::wanted}) {
    drawn.v = v;
    blunt.punches[0].tip_radius = 4.1;  // r 3: within a third up to 4
    EXPECT_EQ(code(l_bracket(), blunt, drawn), "no_tool");
    blunt.punches[0].tip_radius = 3.9;
    EXPECT_EQ(code(l_bracket(), blunt, drawn), "");
  }
  // What is drawn below every tip is bent with the smallest.
  blunt.punches[0].tip_radius = 4.1;
  EXPECT_EQ(code(l_bracket(), blunt), "");
  // 80° tools bend by up to 100°.
  EXPECT_EQ(code(strip({Straight{50}, turn_up(99.9), Straight{50}}, 40, 1.5), plain_tools()), "");
  EXPECT_EQ(code(strip({Straight{50}, turn_up(100.1), Straight{50}}, 40, 1.5), plain_tools()),
            "no_tool");
  PlanOptions springs;
  springs.springback = Angle::degrees(1);
  EXPECT_EQ(
      code(strip({Straight{50}, turn_up(99.9), Straight{50}}, 40, 1.5), plain_tools(), springs),
      "no_tool");
  EXPECT_EQ(code(hem(), plain_tools()), "no_tool");
  EXPECT_EQ(code(as_ruled(l_bracket(), Angle::degrees(5)), plain_tools()), "no_straight_bend");
  PlanOptions wrong;
  wrong.clearance = -1;
  EXPECT_EQ(code(l_bracket(), plain_tools(), wrong), "bad_option");
  // 1.42 · 450 · 2² / 12 N/mm is 213 kN/m.
  BrakeTools weak = plain_tools();
  weak.dies[0].max_force = 212;
  EXPECT_EQ(code(l_bracket(), weak), "no_tool");
  weak.dies[0].max_force = 214;
  EXPECT_EQ(code(l_bracket(), weak), "");
}

/// A bend of 250° is neither a bend of tools nor a hem.
TEST(PlanBending, SendsARollToAnotherMachine) {
  const Sheet rolled = strip({Straight{50}, turn_up(250), Straight{50}}, 40, 1.5);
  const auto plan = plan_of(rolled, plain_tools());
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().code, code::no_tool);
  EXPECT_EQ(plan.error().places, std::vector<Place>{place::bend("B1")});
  EXPECT_EQ(plan.error().where, "B1");
  ASSERT_FALSE(plan.error().numbers.empty());
  EXPECT_EQ(plan.error().numbers[0].name, "angle");
  EXPECT_NEAR(plan.error().numbers[0].quantity.value, 250.0, 1e-9);
  EXPECT_NE(plan.error().message.find("there is no tool that bends by 180° or more"),
            std::string::npos)
      << plan.error().message;
}

/// The time that a plan may take covers the reasons why there is none.
TEST(PlanBending, ExplainsWithinItsTime) {
  std::vector<StripPart> parts{Straight{80}};
  for (int i = 0; i < 24; ++i) {
    parts.push_back(turn_up());
    parts.push_back(Straight{i % 2 == 0 ? 3.0 : 80.0});  // jogs that no die takes twice
  }
  BrakeTools tools = plain_tools();
  for (int i = 0; i < 40; ++i) {
    tools.punches.push_back(tools.punches[0]);
    tools.punches.back().id = "P" + std::to_string(i);
  }
  PlanOptions options;
  options.limits.seconds = 0.5;
  const auto begin = std::chrono::steady_clock::now();
  const auto plan = plan_of(strip(parts, 80, 1.5), tools, options);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  ASSERT_TRUE(plan);
  EXPECT_TRUE(plan->strokes.empty());
  EXPECT_LT(taken.count(), 10.0);  // on a machine that does other things besides
}

TEST(PlanBending, NeedsNoStrokeForAPlateOrARolledBend) {
  const auto plate = plan_of(plate_with_holes(), plain_tools());
  ASSERT_TRUE(plate);
  EXPECT_EQ(plate->status, PlanStatus::optimal);
  EXPECT_TRUE(plate->strokes.empty());
  PlanOptions options;
  options.large_radii = Forming::rolled;
  const auto rolled = plan_of(strip({Straight{50}, turn_up(90, 30), Straight{50}}, 40, 1.5),
                              plain_tools(), options);
  ASSERT_TRUE(rolled);
  EXPECT_TRUE(rolled->strokes.empty());
  ASSERT_EQ(rolled->remarks.size(), 1u);
  EXPECT_EQ(rolled->remarks[0].code, "rolled");
  EXPECT_EQ(rolled->remarks[0].told.places, std::vector<Place>{place::bend("B1")});
}

/// Of the dies that bear the angle the one nearest to the wanted V, 6 · 1.5 mm, is taken, and of
/// two as near the narrower.
TEST(PlanBending, TakesTheNearestV) {
  BrakeTools tools = plain_tools();
  tools.dies.clear();
  for (const double opening : {12.0, 6.0, 8.0, 10.0, 16.0}) {
    tools.dies.push_back(die({opening, Angle::degrees(80), 0.5, 20.0}));
    tools.dies.back().id = std::to_string(static_cast<int>(opening));
  }
  const Sheet sheet = strip({Straight{50}, turn_up(), Straight{50}}, 40, 1.5);
  const auto id = [&](const PlanOptions& options) {
    const auto plan = plan_of(sheet, tools, options);
    return plan ? plan->strokes.at(0).die : "";
  };
  EXPECT_EQ(id({}), "8");
  PlanOptions wide;
  wide.opening = 15.0;
  EXPECT_EQ(id(wide), "16");
}

/// A flange of x takes a V up to 2 (x − q): the widest of the catalogue within 4 T and 12 T costs
/// one for each size away from the wanted one, and is told.
TEST(PlanBending, TakesAnotherVWhereTheWantedDoesNotFit) {
  BrakeTools tools = plain_tools();
  tools.dies = plain_dies({6.0, 8.0, 10.0, 12.0, 16.0});
  const double q = tools.dies.front().shoulder_radius;
  const double half_zone = 0.25 * std::numbers::pi * (2.0 + 0.44 * 2.0);
  const auto plan = [&](double flange, VChoice v) {
    PlanOptions options;
    options.v = v;
    return plan_of(strip({Straight{60}, turn_up(90, 2.0), Straight{flange - half_zone}}, 50, 2.0),
                   tools, options);
  };
  const auto wanted = plan(6.0 + q + 0.01, VChoice::any),
             narrower = plan(6.0 + q - 0.01, VChoice::any),
             narrowest = plan(4.0 + q + 0.01, VChoice::any),
             none = plan(4.0 + q - 0.01, VChoice::any),
             insisted = plan(6.0 + q - 0.01, VChoice::wanted);
  ASSERT_TRUE(wanted && narrower && narrowest && none && insisted);
  EXPECT_EQ(wanted->strokes.at(0).die, "12");
  EXPECT_EQ(wanted->cost, 5.0);  // without a gauge
  EXPECT_TRUE(wanted->remarks.empty());
  EXPECT_EQ(narrower->strokes.at(0).die, "10");
  EXPECT_EQ(narrower->cost, 6.0);
  EXPECT_EQ(narrower->v_away, 1);
  EXPECT_EQ(narrower->strokes.at(0).v_wanted, 12.0);
  // 0.16 · 10 is 0.4 below the drawn radius: more than a tenth, so it is told, as is the V.
  ASSERT_EQ(narrower->remarks.size(), 2u);
  EXPECT_EQ(narrower->remarks[0].code, "other_radius");
  EXPECT_EQ(narrower->remarks[1].code, "other_v");
  EXPECT_NEAR(narrower->remarks[1].told.numbers.at(2).quantity.value, 1.42 * 450 * 4 / 10.0, 1e-9);
  EXPECT_EQ(narrowest->strokes.at(0).die, "8");
  EXPECT_EQ(narrowest->cost, 7.0);
  EXPECT_TRUE(std::ranges::any_of(narrowest->remarks,
                                  [](const Remark& r) { return r.code == "narrow_v"; }));
  EXPECT_EQ(none->status, PlanStatus::infeasible);
  ASSERT_EQ(none->blocked.size(), 1u);
  EXPECT_EQ(none->blocked[0].why->code, "short_side");
  EXPECT_EQ(insisted->status, PlanStatus::infeasible);
}

/// Where the shop's nearest V is far from the wanted one, that is told and costs nothing.
TEST(PlanBending, TellsOfAVThatIsFarFromTheWantedOne) {
  const Sheet sheet = strip(
      {Straight{40}, Turn{Angle::degrees(90), 2, BendDirection::up}, Straight{40}}, 60, 2.0);
  for (const double opening : {9.0, 9.7, 12.0, 14.3, 15.0}) {
    BrakeTools tools = plain_tools();
    tools.dies = {die({opening, Angle::degrees(80)})};
    const auto plan = plan_of(sheet, tools);
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->v_away, 0);
    EXPECT_EQ(std::ranges::count(plan->remarks, "other_v", &Remark::code),
              std::abs(opening - 12.0) > 2.4 ? 1 : 0)
        << opening;
  }
}

/// What is pressed together takes the force of all.
TEST(PlanBending, PressesApartWhatIsTooMuchTogether) {
  const Sheet sheet = two_flaps();
  BrakeTools tools = plain_tools();
  // 40 mm over a V of 12 take 2.13 kN.
  for (const double force : {4.27, 4.25, 2.14, 2.12}) {
    tools.machine.force = force;
    const auto plan = plan_of(sheet, tools);
    if (force < 2.13) {
      ASSERT_FALSE(plan);
      EXPECT_EQ(plan.error().code, code::press_too_small);
      continue;
    }
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(plan->strokes.size(), force > 4.26 ? 1u : 2u) << force;
  }
}

/// Longer than the press: that is said, not what it would hit.
TEST(PlanBending, NeedsAPressAsLongAsTheBend) {
  BrakeTools tools = plain_tools();
  tools.punches[0].segments = tools.dies[0].segments = {500, 200, 100, 50, 20, 10};
  const Sheet sheet = strip({Straight{50}, turn_up(), Straight{50}}, 400, 1.5);
  tools.machine.length = 400.0;
  EXPECT_TRUE(plan_of(sheet, tools));
  tools.machine.length = 396.9;  // 400 less 1.5 at each end is 397
  const auto plan = plan_of(sheet, tools);
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().code, code::press_too_small);
  EXPECT_NE(plan.error().message.find("396.9"), std::string::npos) << plan.error().message;
}

/// Random sheets: what must not change the answer does not.
class PlanInvariants : public testing::Test {
 protected:
  struct Case {
    Sheet sheet;
    BrakeTools tools;
  };
  static std::vector<Case> cases(int bends = 4) {
    std::mt19937 random(99);
    std::vector<Case> cases;
    for (int i = 0; i < 24; ++i) {
      Case made{random_sheet(random, bends), plain_tools()};
      made.tools.punches[0].tip_radius = 0.05;
      made.tools.punches[0].profile[1].x() = 6.0;  // not its own mirror image
      made.tools.punches[0].profile[2].x() = 6.0;
      made.tools.punches[0].profile[1].y() *= 0.6;
      made.tools.punches[0].angle = Angle::degrees(30);
      made.tools.punches[0].profile = {{0, 0}, {4, 14.93}, {4, 120}, {-9, 120}, {-9, 33.6}};
      const double t = made.sheet.thickness;
      made.tools.dies[0] = die({6.0 * t,
                                Angle::degrees(30),
                                0.3 * t,
                                3.0 * t + 8.0,
                                100.0,
                                {500, 300, 200, 100, 50, 20, 15, 10, 5}});
      made.tools.punches[0].segments = made.tools.dies[0].segments;
      cases.push_back(std::move(made));
    }
    return cases;
  }
  struct Answer {
    bool planned = false;
    PlanStatus status = PlanStatus::gave_up;
    double cost = 0.0;
    int other_ways = 0;  ///< of large bends: bumps count once, rolling twice
    /// What is rolled costs no stroke, and is worse than any.
    std::pair<int, double> worth() const { return {other_ways, cost}; }
    friend bool operator==(const Answer&, const Answer&) = default;
  };
  static Answer answer(const Case& asked, const PlanOptions& options = {},
                       const FlattenOptions& flattening = {}) {
    PlanOptions patient = options;
    patient.limits.seconds = 600.0;  // the machine may do other things besides
    const auto plan = plan_of(asked.sheet, asked.tools, patient, flattening);
    if (!plan) return {};
    Answer answer{true, plan->status, plan->cost};
    for (const LargeBend& large : plan->large)
      answer.other_ways += static_cast<int>(large.forming);
    return answer;
  }
  /// Those of the cases as they are, asked for once.
  static const std::vector<Answer>& answers() {
    static const std::vector<Answer> known = [] {
      std::vector<Answer> all;
      for (const Case& asked : cases())
        all.push_back(answer(asked));
      return all;
    }();
    return known;
  }
};

TEST_F(PlanInvariants, TheWayThePatternLiesChangesNothing) {
  int planned = 0, infeasible = 0;
  for (const Case& asked : cases()) {
    FlattenOptions reference, other, kept;
    reference.up = UpSide::reference;
    other.up = UpSide::other;
    kept.keep_root = true;
    const Answer first = answer(asked, {}, reference);
    EXPECT_EQ(first, answer(asked, {}, other));
    EXPECT_EQ(first, answer(asked, {}, kept));
    planned += first.planned && first.status == PlanStatus::optimal;
    infeasible += first.planned && first.status == PlanStatus::infeasible;
  }
  EXPECT_GT(planned, 2);
  EXPECT_GT(infeasible, 2);
}

TEST_F(PlanInvariants, MirroredToolsOnlyTurnTheSheetRound) {
  std::size_t number = 0;
  for (const Case& asked : cases()) {
    Case mirrored = asked;
    for (ToolProfile* profile :
         {&mirrored.tools.punches[0].profile, &mirrored.tools.dies[0].profile}) {
      std::ranges::reverse(*profile);
      for (Vec2& p : *profile)
        p.x() = -p.x();
    }
    EXPECT_EQ(answers()[number++], answer(mirrored));
  }
}

TEST_F(PlanInvariants, MorePunchesAreNeverWorse) {
  std::size_t number = 0;
  for (const Case& asked : cases()) {
    const Answer few = answers()[number++];
    if (few.status != PlanStatus::optimal) continue;
    Case more = asked;
    more.tools.punches.push_back(asked.tools.punches[0]);
    more.tools.punches.back().id = "thin";
    more.tools.punches.back().profile = {{0, 0}, {3, 11.2}, {3, 120}, {-3, 120}, {-3, 11.2}};
    const Answer many = answer(more);
    EXPECT_EQ(many.status, PlanStatus::optimal);
    EXPECT_LE(many.worth(), few.worth());
  }
}

TEST_F(PlanInvariants, ClearanceNeverHelps) {
  std::size_t number = 0;
  for (const Case& asked : cases()) {
    const Answer without = answers()[number++];
    bool was_infeasible = without.status == PlanStatus::infeasible;
    auto worth = without.worth();
    for (const double clearance : {0.5, 2.0}) {
      PlanOptions options;
      options.clearance = clearance;
      const Answer now = answer(asked, options);
      if (!now.planned) continue;
      if (was_infeasible) {
        EXPECT_EQ(now.status, PlanStatus::infeasible);
      }
      if (now.status == PlanStatus::optimal) {
        EXPECT_GE(now.worth(), worth);
      }
      was_infeasible = now.status == PlanStatus::infeasible;
      worth = now.worth();
    }
  }
}

/// The part seen in a mirror that lies in its pattern: what goes up goes down.
Sheet mirror_image(Sheet sheet) {
  for (Bend& bend : sheet.bends)
    bend.reference_inside = !bend.reference_inside;
  return sheet;
}

/// The same sheet with its bends and flanges numbered from the other end.
Sheet renumbered(const Sheet& sheet) {
  Sheet other = sheet;
  const auto bend_of = [&](BendId id) {
    return static_cast<BendId>(static_cast<int>(sheet.bends.size()) - 1 - index_of(id));
  };
  const auto flange_of = [&](FlangeId id) {
    return static_cast<FlangeId>(static_cast<int>(sheet.flanges.size()) - 1 - index_of(id));
  };
  for (const BendId id : sheet.bends.ids())
    other.bends[bend_of(id)] = sheet.bends[id];
  for (const FlangeId id : sheet.flanges.ids())
    other.flanges[flange_of(id)] = sheet.flanges[id];
  for (Face& face : other.faces) {
    if (auto* bend = std::get_if<BendId>(&face.part_of)) *bend = bend_of(*bend);
    if (auto* flange = std::get_if<FlangeId>(&face.part_of)) *flange = flange_of(*flange);
  }
  for (Joint& joint : other.joints)
    if (joint.sharp) joint.sharp = bend_of(*joint.sharp);
  return other;
}

TEST_F(PlanInvariants, APartThatIsMovedMirroredOrRenumberedHasTheSamePlan) {
  const Eigen::Isometry3d motion = Eigen::Translation3d(70.0, -30.0, 900.0) *
                                   Eigen::AngleAxisd(1.1, Vec3(1, -2, 3).normalized());
  std::size_t most_bends = 0;
  int planned = 0, infeasible = 0;
  for (const Case& asked : cases(7)) {
    const Answer first = answer(asked);
    // Impossible parts take the longest, and a few of them tell enough.
    if (first.status == PlanStatus::infeasible && infeasible > 3) continue;
    for (const Sheet& same :
         {moved(asked.sheet, motion), mirror_image(asked.sheet), renumbered(asked.sheet)})
      EXPECT_EQ(first, answer({same, asked.tools}));
    most_bends = std::max(most_bends, asked.sheet.bends.size());
    planned += first.planned && first.status == PlanStatus::optimal;
    infeasible += first.planned && first.status == PlanStatus::infeasible;
  }
  EXPECT_GE(most_bends, 6u);
  EXPECT_GE(planned, 2);
  EXPECT_GT(infeasible, 2);
}

/// Dies of the opening that is taken anyhow: a narrower one and one for smaller angles.
TEST_F(PlanInvariants, MoreDiesOfTheSameOpeningAreNeverWorse) {
  int looked = 0;
  std::size_t number = 0;
  for (const Case& asked : cases()) {
    const Answer few = answers()[number++];
    if (few.status != PlanStatus::optimal) continue;
    Case more = asked;
    const double opening = asked.tools.dies[0].opening;
    more.tools.dies.push_back(die({opening, Angle::degrees(28), asked.tools.dies[0].shoulder_radius,
                                   0.5 * opening + 2.0, 100.0, asked.tools.dies[0].segments}));
    more.tools.dies.back().id = "narrow";
    const Answer many = answer(more);
    ++looked;
    EXPECT_EQ(many.status, PlanStatus::optimal);
    EXPECT_LE(many.worth(), few.worth());
  }
  EXPECT_GT(looked, 2);
}

/// What a plan says of itself holds: every stroke keeps the clearance it reports.
TEST_F(PlanInvariants, ReportedClearanceIsKept) {
  int looked = 0;
  std::size_t number = 0;
  for (const Case& asked : cases()) {
    if (answers()[number++].status != PlanStatus::optimal) continue;
    const auto plan = plan_of(asked.sheet, asked.tools);
    if (!plan || plan->status != PlanStatus::optimal) continue;
    double least = 1e9;
    for (const Stroke& stroke : plan->strokes)
      least = std::min(least, stroke.clearance);
    if (least < 0.1 || least > 900.0) continue;
    ++looked;
    // The same order with the clearance asked: possible below the least, not above.
    PlanOptions options;
    for (const Stroke& stroke : plan->strokes)
      options.begin_with.insert(options.begin_with.end(), stroke.bends.begin(), stroke.bends.end());
    options.clearance = least - 0.02;
    EXPECT_EQ(answer(asked, options).status, PlanStatus::optimal) << least;
  }
  EXPECT_GT(looked, 2);
}

}  // namespace
}  // namespace planish::test
