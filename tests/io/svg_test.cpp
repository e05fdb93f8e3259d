#include "sample_patterns.hpp"
#include "svg_labels.hpp"
#include "svg_shapes.hpp"

#include <planish/geometry/region.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish {
namespace {

using namespace io_detail;
using namespace sample;
using testing::HasSubstr;
using testing::Not;

TEST(Svg, HasTheTrueSizeOfThePartAndItsMargin) {
  const std::string svg = svg_text(bracket(), {.margin = 5.0, .labels = false, .legend = false});
  EXPECT_THAT(svg, HasSubstr("width=\"210mm\" height=\"110mm\" viewBox=\"-5 -105 210 110\""));
}

TEST(Svg, DrawsUpBlueAndDownRedAndSaysSo) {
  const std::string svg = svg_text(bracket());
  EXPECT_THAT(svg, HasSubstr("fill=\"#1d5fc4\" stroke-width"));
  EXPECT_THAT(svg, HasSubstr(">B1 UP 90° R2</text>"));
  EXPECT_THAT(svg, HasSubstr(">B2 DOWN 90° R2</text>"));
  EXPECT_THAT(svg, HasSubstr(">200 × 100 × 2 mm</text>"));
  EXPECT_THAT(svg, HasSubstr(">bend down</text>"));
  EXPECT_THAT(svg_text(bracket(), {.labels = false, .legend = false}), Not(HasSubstr("<text")));
}

TEST(Svg, EscapesWhatXmlWouldMisread) {
  FlatPattern pattern = bracket();
  pattern.bends[0].id = "<a & \"b\">\x01";
  pattern.features.push_back({"<em>boss", FormSide::up, {hole({20, 50}, 11.0)}});
  const std::string svg = svg_text(pattern);
  EXPECT_THAT(svg, HasSubstr("&lt;a &amp; &quot;b&quot;&gt; UP"));
  EXPECT_THAT(svg, HasSubstr("<title>&lt;em&gt;boss, up</title>"));
  EXPECT_EQ(svg.find('\x01'), std::string::npos);
}

TEST(Svg, DrawsAnEmptyPatternAsAnEmptyPage) {
  const std::string svg = svg_text({});
  EXPECT_THAT(svg, HasSubstr("</svg>"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

}  // namespace
}  // namespace planish
