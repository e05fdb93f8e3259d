#include <planish/job/run.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace planish::job {
namespace {

using nlohmann::json;

TEST(TransitionSolids, AreMadeWhereCurvesAreFittedBetweenTheirNodes) {
  // The borders of the cones meet their surfaces at the nodes of the fit to 1e-10 mm, and between
  // them to 3e-7 mm: an edge must bear that.
  const json file = {
      {"format", "planish/transition"},
      {"version", 1},
      {"thickness", 0.094},
      {"press_lines", {{"max_angle", 15}}},
      {"from",
       {{"profile",
         {{"polygon",
           {{-143.2, -110.5},
            {18.6, -163.4},
            {192.4, -18.7},
            {151.9, 101.9},
            {-27.5, 162.5},
            {-192.9, 14.7}}}}}}},
      {"to",
       {{"frame", {{"origin", {0, 0, 417}}, {"normal", {0, 0, 1}}, {"x", {1, 0, 0}}}},
        {"profile",
         {{"rounded_rectangle", {{"width", 354.5}, {"height", 215.9}, {"radius", 20.1}}}}}}}};
  const json request = {{"maker", "transition"},
                        {"input", {{"name", "t.json"}, {"content", file}}},
                        {"artifacts", {"step"}}};
  const auto result = run(request.dump());
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->artifacts.size(), 1u);
  const json report = json::parse(result->report);
  for (const json& finding : report["checks"])
    EXPECT_NE(finding["code"], "folded_solid") << finding["message"];
  EXPECT_NEAR(report["verification"]["explained_ratio"].get<double>(), 1.0, 1e-5);
}

}  // namespace
}  // namespace planish::job
