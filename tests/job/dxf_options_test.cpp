#include "job/option_meanings.hpp"
#include "option_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::job {
namespace {

TEST(DxfOptions, SetWhatTheyAreNamedFor) {
  test::expect_meanings(
      {{"profile", "default", [](auto& r) { return r.dxf.profile == LayerProfile::standard; }},
       {"profile", "inventor", [](auto& r) { return r.dxf.profile == LayerProfile::inventor; }},
       {"profile", "onshape", [](auto& r) { return r.dxf.profile == LayerProfile::onshape; }},
       {"profile", "solidedge", [](auto& r) { return r.dxf.profile == LayerProfile::solid_edge; }},
       {"r12", "true", [](auto& r) { return r.dxf.version == DxfVersion::r12; }},
       {"r12", "false", [](auto& r) { return r.dxf.version == DxfVersion::r2000; }},
       {"splines", "keep", [](auto& r) { return r.dxf.splines == Splines::keep; }},
       {"splines", "arcs", [](auto& r) { return r.dxf.splines == Splines::arcs; }},
       {"arc_tolerance", "0.5", [](auto& r) { return r.dxf.arc_tolerance == 0.5; }},
       {"bend_marks", "ticks", [](auto& r) { return r.dxf.bend_marks == BendMarks::ticks; }},
       {"bend_marks", "lines", [](auto& r) { return r.dxf.bend_marks == BendMarks::lines; }},
       {"tangent_lines", "true", [](auto& r) { return r.dxf.tangent_lines; }},
       {"bend_text", "true", [](auto& r) { return r.dxf.bend_text; }},
       {"turn_to_blank", "true", [](auto& r) { return r.dxf.turn_to_blank; }}});
}

TEST(DxfOptions, SetTheLengthOfTicksBesideTicks) {
  OptionValues values;
  ASSERT_TRUE(values.set_text(option("tick_length"), "3"));
  ASSERT_TRUE(values.set_text(option("bend_marks"), "ticks"));
  Request request;
  ASSERT_TRUE(values.enter(request));
  EXPECT_EQ(request.dxf.tick_length, 3.0);
}

TEST(DxfOptions, AreAllOfThatGroup) {
  for (const Option& one : dxf_options())
    EXPECT_EQ(one.group, OptionGroup::dxf) << one.name;
  EXPECT_EQ(std::ranges::count(options(), OptionGroup::dxf, &Option::group),
            std::ssize(dxf_options()));
}

}  // namespace
}  // namespace planish::job
