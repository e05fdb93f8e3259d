#include <planish/job/options.hpp>
#include <planish/job/request.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::job {
namespace {

TEST(BendingOptions, AreRefusedByNameIfTheySayNothing) {
  const auto entered = [](const char* name, const char* text) {
    OptionValues values;
    EXPECT_TRUE(values.set_text(option(name), text));
    Request request;
    return values.enter(request);
  };
  for (const char* text :
       {"turn_over", "turn_over=", "turn_over=-1", "turn=3", "rotate=2,", "rotate=nan", "=3"}) {
    const auto done = entered("weights", text);
    ASSERT_FALSE(done) << text;
    EXPECT_EQ(done.error().code, code::bad_option);
    EXPECT_EQ(done.error().where, "weights");
  }
  EXPECT_TRUE(entered("weights", "turn_over=3,rotate=0.5"));
}

TEST(BendingOptions, SetWhatTheyAreNamedFor) {
  OptionValues values;
  for (const auto& [name, text] :
       std::vector<std::pair<const char*, const char*>>{{"metal", "stainless"},
                                                        {"clearance", "0.5"},
                                                        {"shortfall", "3"},
                                                        {"opening", "12"},
                                                        {"weights", "turn_over=7,ungauged=0"},
                                                        {"fix", "B3,B1"},
                                                        {"gauge_openings", "true"},
                                                        {"as_made", "true"},
                                                        {"search_time", "2.5"}})
    EXPECT_TRUE(values.set_text(option(name), text)) << name;
  Request request;
  ASSERT_TRUE(values.enter(request));
  const PlanOptions& plan = request.bending.plan;
  EXPECT_EQ(plan.tensile_strength, 700.0);
  EXPECT_NEAR(plan.springback.degrees(), 3.0, 1e-12);
  EXPECT_EQ(plan.clearance, 0.5);
  EXPECT_EQ(plan.shortfall, 3.0);
  EXPECT_EQ(plan.opening, 12.0);
  EXPECT_EQ(plan.weights.turn_over, 7.0);
  EXPECT_EQ(plan.weights.ungauged, 0.0);
  EXPECT_EQ(plan.weights.rotate, StrokeWeights{}.rotate);
  EXPECT_EQ(plan.limits.seconds, 2.5);
  EXPECT_TRUE(plan.gauge_openings);
  EXPECT_TRUE(request.bending.as_made);
  EXPECT_THAT(request.bending.begin_with, testing::ElementsAre("B3", "B1"));
}

TEST(BendingOptions, LetSpringbackOverrideThatOfTheMetal) {
  OptionValues values;
  EXPECT_TRUE(values.set_text(option("springback"), "0.5"));
  EXPECT_TRUE(values.set_text(option("metal"), "aluminium"));
  Request request;
  ASSERT_TRUE(values.enter(request));
  EXPECT_NEAR(request.bending.plan.springback.degrees(), 0.5, 1e-12);
  EXPECT_EQ(request.bending.plan.tensile_strength, 270.0);
}

}  // namespace
}  // namespace planish::job
