#include <planish/io/page.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>

namespace planish {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

Page square() {
  Page page;
  page.items.emplace_back(PagePath{{{10, 10}, {20, 10}, {20, 20}, {10, 20}}, kBlack, 0.5, true});
  page.items.emplace_back(PageText{{10, 30}, "a square", 5.0});
  return page;
}

std::size_t number_at(const std::string& text, std::size_t at) {
  return std::stoul(text.substr(at, 10));
}

TEST(PdfText, HasATableThatLeadsToEachObject) {
  const std::string pdf = pdf_text({square(), square()});
  EXPECT_THAT(pdf, StartsWith("%PDF-1.4\n"));
  EXPECT_TRUE(pdf.ends_with("%%EOF\n"));
  const std::size_t told = pdf.find("startxref\n");
  const std::size_t table = number_at(pdf, told + 10);
  ASSERT_EQ(pdf.substr(table, 7), "xref\n0 ");
  const std::size_t objects = number_at(pdf, table + 7);
  // Two fonts, a content and a page for each sheet, the list of pages and the catalogue.
  EXPECT_EQ(objects, 1u + 2u + 4u + 2u);
  const std::size_t first = pdf.find('\n', table + 5) + 1;
  for (std::size_t i = 1; i < objects; ++i) {
    const std::string entry = pdf.substr(first + 20 * i, 20);
    EXPECT_EQ(entry.substr(10), " 00000 n \n");
    EXPECT_THAT(pdf.substr(number_at(entry, 0), 20), StartsWith(std::to_string(i) + " 0 obj\n"));
  }
}

TEST(PdfText, TellsTheLengthOfEachStream) {
  const std::string pdf = pdf_text({square()});
  const std::regex stream("<< /Length (\\d+) >>\nstream\n");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(pdf, found, stream));
  const std::size_t begin = found.position() + found.length();
  EXPECT_EQ(pdf.substr(begin + std::stoul(found[1]), 10), "\nendstream");
}

TEST(PdfText, MeasuresInPoints) {
  // A4 is 595.276 by 841.890 points, 25.4 mm are 72.
  Page page;
  page.items.emplace_back(PagePath{{{25.4, 50.8}, {76.2, 50.8}}, kBlack, 2.54});
  const std::string pdf = pdf_text({page});
  EXPECT_THAT(pdf, HasSubstr("/MediaBox [0 0 595.276 841.890]"));
  EXPECT_THAT(pdf, HasSubstr("7.200 w"));
  EXPECT_THAT(pdf, HasSubstr("72.000 144.000 m\n216.000 144.000 l\nS\n"));
}

TEST(PdfText, EscapesAndWritesLatin) {
  Page page;
  page.items.emplace_back(PageText{{0, 0}, "90° (a\\b) Stück 板", 3.0});
  EXPECT_THAT(pdf_text({page}), HasSubstr("(90\xB0 \\(a\\\\b\\) St\xFC"
                                          "ck ?) Tj"));
}

TEST(PdfText, IsTheSameForTheSamePages) { EXPECT_EQ(pdf_text({square()}), pdf_text({square()})); }

TEST(TextWidth, IsThatOfTheStandardFont) {
  // Adobe's metrics: H 722, i 222, and in bold 722 and 278 thousandths.
  EXPECT_NEAR(text_width("Hi", 10.0, false), 9.44, 1e-12);
  EXPECT_NEAR(text_width("Hi", 10.0, true), 10.0, 1e-12);
  EXPECT_EQ(text_width("", 10.0, false), 0.0);
}

TEST(PdfText, PutsTextWhereItsAnchorIs) {
  Page page;
  page.items.emplace_back(PageText{{100, 0}, "Hi", 25.4 / 7.2, TextAnchor::end});
  // 9.44 points before 283.465.
  EXPECT_THAT(pdf_text({page}), HasSubstr("274.025 0.000 Td"));
}

TEST(PagesAsSvg, StandBelowEachOther) {
  const std::string svg = svg_text(std::vector<Page>{square(), square()});
  EXPECT_THAT(svg, HasSubstr("viewBox=\"0 0 210.000 599.000\""));
  EXPECT_THAT(svg, HasSubstr("translate(0 302.000)"));
  // y is up on a page and down in SVG.
  EXPECT_THAT(svg, HasSubstr("<polygon points=\"10.000,287.000 20.000,287.000"));
}

TEST(PagesAsSvg, EscapeText) {
  Page page;
  page.items.emplace_back(PageText{{0, 0}, "<a & b>", 3.0});
  const std::string svg = svg_text(std::vector<Page>{page});
  EXPECT_THAT(svg, HasSubstr("&lt;a &amp; b&gt;"));
  EXPECT_THAT(svg, Not(HasSubstr("<a &")));
}

}  // namespace
}  // namespace planish
