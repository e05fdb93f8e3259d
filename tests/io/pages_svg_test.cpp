#include <planish/io/pages.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace planish {
namespace {

TEST(PagesSvg, LiesPagesBelowOneAnother) {
  const std::string svg = pages_svg({Page(210, 297), Page(297, 210), Page(100, 50)});
  EXPECT_NE(svg.find("width=\"297mm\" height=\"557mm\" viewBox=\"0 0 297 557\""),
            std::string::npos);
  const size_t second = svg.find("<g transform=\"translate(0 297)\">");
  const size_t third = svg.find("<g transform=\"translate(0 507)\">");
  EXPECT_LT(svg.find("<g transform=\"translate(0 0)\">"), second);
  EXPECT_LT(second, third);
  EXPECT_NE(third, std::string::npos);
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
}

TEST(PagesSvg, DrawsLinesAndAreasInTheirInk) {
  Page page(100, 50);
  page.lines({{{1, 2}, {3, 4.5}, {5, 6}}, {{7, 8}, {9, 10}}},
             {{{1.0, 0.5, 0.0}}, {}, 0.35, {2, 1.5}});
  page.area({{{0, 0}, {10, 0}, {0, 10}}}, {{}, {{0.0, 0.2, 1.0}}, 0.1, {}});
  const std::string svg = pages_svg({page});
  EXPECT_NE(svg.find("<path d=\"M1 2L3 4.5L5 6M7 8L9 10\" fill=\"none\" stroke=\"#ff8000\" "
                     "stroke-width=\"0.35\" stroke-dasharray=\"2 1.5\"/>"),
            std::string::npos)
      << svg;
  EXPECT_NE(svg.find("<path d=\"M0 0L10 0L0 10Z\" fill=\"#0033ff\" stroke=\"none\" "
                     "stroke-width=\"0.1\"/>"),
            std::string::npos)
      << svg;
  EXPECT_LT(svg.find("M1 2"), svg.find("M0 0L10")) << "in the order in which they were drawn";
}

TEST(PagesSvg, SetsTextsAboveShapes) {
  Page page(100, 50);
  page.text({10, 20.5}, "a < b & \"c\"");
  page.text({30, 40}, "turned", {5, true, TextAnchor::middle, {1, 0, 0}, std::numbers::pi / 2});
  page.text({50, 40}, "end", {.anchor = TextAnchor::end});
  page.line({0, 0}, {1, 1});
  const std::string svg = pages_svg({page});
  EXPECT_NE(svg.find("<text x=\"10\" y=\"20.5\" font-size=\"3.5\" text-anchor=\"start\" "
                     "fill=\"#000000\">a &lt; b &amp; "),
            std::string::npos)
      << svg;
  EXPECT_NE(
      svg.find("<text x=\"30\" y=\"40\" font-size=\"5\" text-anchor=\"middle\" "
               "fill=\"#ff0000\" font-weight=\"bold\" transform=\"rotate(-90 30 40)\">turned"),
      std::string::npos)
      << "SVG turns clockwise: " << svg;
  EXPECT_NE(svg.find("text-anchor=\"end\""), std::string::npos);
  EXPECT_LT(svg.find("<path"), svg.find("<text"));
}

}  // namespace
}  // namespace planish
