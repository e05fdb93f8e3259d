#include <planish/io/codes.hpp>
#include <planish/io/pages.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace planish::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Page sample() {
  Page page(297.0, 210.0);
  page.area({{{10, 10}, {50, 10}, {50, 40}, {10, 40}}, {{20, 20}, {20, 30}, {30, 30}, {30, 20}}},
            {.fill = Colour{1.0, 0.5, 0.0}, .width = 0.5});
  page.line({10, 60}, {50, 60}, {.stroke = Colour{0.0, 0.0, 1.0}, .dashes = {3.0, 1.5}});
  page.text({30, 80}, "R < 2 & more", {.size = 5.0, .bold = true, .anchor = TextAnchor::middle});
  page.text({30, 90}, "up", {.turned = std::numbers::pi / 2});
  return page;
}

TEST(Pages, AreSvgInMillimetres) {
  const std::string svg = pages_svg({sample()});
  EXPECT_THAT(svg, HasSubstr(R"(width="297mm" height="210mm" viewBox="0 0 297 210")"));
  EXPECT_THAT(svg, HasSubstr("M10 10L50 10L50 40L10 40ZM20 20L20 30L30 30L30 20Z"));
  EXPECT_THAT(svg, HasSubstr(R"(fill="#ff8000" stroke="#000000" stroke-width="0.5")"));
  EXPECT_THAT(svg, HasSubstr(R"(stroke="#0000ff" stroke-width="0.25" stroke-dasharray="3 1.5")"));
  EXPECT_THAT(svg, HasSubstr("R &lt; 2 &amp; more"));
  EXPECT_THAT(svg, HasSubstr(R"(text-anchor="middle" fill="#000000" font-weight="bold")"));
  EXPECT_THAT(svg, HasSubstr(R"x(transform="rotate(-90 30 90)")x"));
}

TEST(Pages, ArePdfWithEmbeddedLetters) {
  Page upright(210.0, 297.0);
  upright.text({10, 10}, "Ø 6.6 × 90° – ½");
  const auto pdf = pages_pdf({sample(), upright}, "bracket");
  ASSERT_TRUE(pdf) << pdf.error().message;
  EXPECT_EQ(pdf->rfind("%PDF-", 0), 0u);
  EXPECT_THAT(*pdf, HasSubstr("/Count 2"));
  // 297 mm and 210 mm are 841.89 and 595.28 points.
  EXPECT_THAT(*pdf, HasSubstr("[ 0 0 841.889764 595.275591 ]"));
  EXPECT_THAT(*pdf, HasSubstr("[ 0 0 595.275591 841.889764 ]"));
  EXPECT_THAT(*pdf, HasSubstr("/FontFile"));
  EXPECT_THAT(*pdf, HasSubstr("(bracket)"));
}

TEST(Pages, AreTheSameBytesEachTime) {
  const auto once = pages_pdf({sample()}, "a"), again = pages_pdf({sample()}, "a");
  ASSERT_TRUE(once && again);
  EXPECT_EQ(*once, *again);
  EXPECT_THAT(*once, Not(HasSubstr("/CreationDate")));
}

TEST(Pages, WithoutAnyAreAnError) {
  const auto none = pages_pdf({}, "nothing");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, code::cannot_draw);
}

}  // namespace
}  // namespace planish::test
