#include <planish/base/message.hpp>

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace planish {
namespace {

std::string said(std::string_view pattern, const Facts& facts) {
  return tell(pattern, facts).sentence;
}

TEST(Tell, FillsQuantitiesWithTheirUnits) {
  EXPECT_EQ(said("off by {off}", {{"off", 18.2049, unit::mm}}), "off by 18.2 mm");
  EXPECT_EQ(said("turns {angle}", {{"angle", 90.0, unit::degrees}}), "turns 90°");
  EXPECT_EQ(said("{share} is gone", {{"share", 12.5, unit::percent}}), "12.5 % is gone");
  EXPECT_EQ(said("{length:6}", {{"length", 1234.5678, unit::mm}}), "1234.57 mm");
}

TEST(Tell, AgreesInNumber) {
  EXPECT_EQ(said("{n:bend}", {{"n", 1}}), "1 bend");
  EXPECT_EQ(said("{n:bend}", {{"n", 0}}), "0 bends");
  EXPECT_EQ(said("{n:body/bodies}", {{"n", 2}}), "2 bodies");
  EXPECT_EQ(said("{n:body/bodies}", {{"n", 1}}), "1 body");
  EXPECT_EQ(said("{n}", {{"n", 123456789}}), "123456789");
}

TEST(Tell, NamesPlacesAsPeopleCount) {
  EXPECT_EQ(said("at {@p}", {{"p", place::face(12)}}), "at face 12");
  EXPECT_EQ(said("at {@p}", {{"p", place::strip(2)}}), "at strip 3");
  EXPECT_EQ(said("at {@p}", {{"p", place::plate("floor")}}), "at plate \"floor\"");
  EXPECT_EQ(said("at {@p}", {{"p", place::bend("B2")}}), "at bend B2");
  EXPECT_EQ(said("at {@p}", {{"p", place::line(7)}}), "at line 7");
  EXPECT_EQ(said("at {@p}", {{"p", place::edge(21)}}), "at edge 21");
  EXPECT_EQ(said("at {@p}", {{"p", place::edge(21, {7, 9})}}),
            "at edge 21 between face 7 and face 9");
  const std::array<double, 2> p{12.5, -0.0};
  EXPECT_EQ(said("at {@p}", {{"p", place::point(p)}}), "at (12.5, 0)");
}

TEST(Tell, ListsPlacesOfOneName) {
  const Facts faces{{"f", place::face(3)}, {"f", place::face(5)}, {"f", place::face(12)}};
  EXPECT_EQ(said("{@f} meet", faces), "Faces 3, 5 and 12 meet");
  const Facts mixed{{"p", place::face(3)}, {"p", place::edge(5)}};
  EXPECT_EQ(said("at {@p}", mixed), "at face 3 and edge 5");
}

TEST(Tell, LeavesTheKindOut) {
  EXPECT_EQ(said("{@b:id}: too low", {{"b", place::bend("B2")}}), "B2: too low");
  EXPECT_EQ(said("at {@p:id}", {{"p", place::face(3)}, {"p", place::edge(5)}}), "at 3 and 5");
}

TEST(SayAfter, MovesWhatTheSecondSentenceNames) {
  Told told = tell("at {@p}", {{"p", place::face(3)}, {"a", 1.0, unit::mm}});
  say_after(told, "; ", tell("set `root` at {@q}", {{"q", place::bend("B1")}, {"b", 2}}));
  EXPECT_EQ(told.sentence, "at face 3; set `root` at bend B1");
  EXPECT_EQ(told.places, (std::vector<Place>{place::face(3), place::bend("B1")}));
  ASSERT_EQ(told.numbers.size(), 2u);
  EXPECT_EQ(told.numbers[1].name, "b");
  std::vector<std::string> texts;
  for (const Piece& piece : wording(told))
    texts.push_back(piece.text);
  EXPECT_EQ(texts,
            (std::vector<std::string>{"at ", "face 3", "; set ", "`root`", " at ", "bend B1"}));
}

TEST(InUnits, LengthsAreasAndVolumesAreInInches) {
  const Told told = tell("{@bend}: {a}, {b:6}, {c}, {d}, {e}, {n:hole}",
                         {{"bend", place::bend("B1")},
                          {"a", 25.4, unit::mm},
                          {"b", 3225.8, unit::mm2},
                          {"c", 16387.064, unit::mm3},
                          {"d", 90.0, unit::degrees},
                          {"e", 2.0, unit::kilonewtons},
                          {"n", 3}});
  EXPECT_EQ(in_units(told, LengthUnit::inch).sentence,
            "Bend B1: 1 in, 5 in², 1 in³, 90°, 2 kN, 3 holes");
  EXPECT_EQ(in_units(told, LengthUnit::m).sentence,
            "Bend B1: 0.0254 m, 0.0032258 m², 1.639e-05 m³, 90°, 2 kN, 3 holes");
  EXPECT_EQ(in_units(told, LengthUnit::mm).sentence, told.sentence);
}

TEST(InUnits, ANumberWithoutItsUnitIsConvertedToo) {
  const Told told = tell("{a:number} × {b}", {{"a", 304.8, unit::mm}, {"b", 25.4, unit::mm}});
  EXPECT_EQ(told.sentence, "304.8 × 25.4 mm");
  EXPECT_EQ(in_units(told, LengthUnit::inch).sentence, "12 × 1 in");
}

TEST(InUnits, SentencesWithinSentencesAndListsAreToo) {
  const Told inner = tell("between {near}", {{"near", 25.4, unit::mm}, {"near", 50.8, unit::mm}});
  const Told outer = tell("at {@p}; the worst: {worst}; set `root`",
                          {{"p", Place{PlaceKind::point, {}, {254.0, 12.7}}}, {"worst", inner}});
  const Told inches = in_units(outer, LengthUnit::inch);
  EXPECT_EQ(inches.sentence, "at (10, 0.5); the worst: between 1 in and 2 in; set `root`");
  EXPECT_EQ(inches.named.back().text, "`root`");
  EXPECT_EQ(inches.sentence.substr(inches.named.back().at), "`root`");
}

TEST(Tell, NamesBodiesAndTheWholeOfAFile) {
  EXPECT_EQ(said("{@body} differ", {{"body", place::body(2)}, {"body", place::body(5)}}),
            "Bodies 2 and 5 differ");
  EXPECT_EQ(said("in {@field}", {{"field", place::pointer("")}}), "in the whole input");
  EXPECT_EQ(said("in {@field}", {{"field", place::pointer("/" + std::string(300, 'a'))}}).size(),
            3 + 200 + std::string("…").size());
}

TEST(Tell, BeginsWithACapitalOnlyAtAPlace) {
  EXPECT_EQ(said("{@p} is bent", {{"p", place::face(1)}}), "Face 1 is bent");
  EXPECT_EQ(said("{file} is empty", {{"file", "part.step"}}), "part.step is empty");
}

TEST(Tell, LeavesAsItStandsWhatItHasNoFactFor) {
  EXPECT_EQ(said("{x} and {@y}", {{"z", 1}}), "{x} and {@y}");
  EXPECT_EQ(said("{@x} is no place", {{"x", "words"}}), "{@x} is no place");
  EXPECT_EQ(said("open {x", {{"x", 1}}), "open {x");
}

TEST(Tell, KeepsFactsThatItDoesNotName) {
  const Told told = tell("too thick", {{"p", place::flange(2)}, {"t", 3.0, unit::mm}});
  ASSERT_EQ(told.places.size(), 1);
  EXPECT_EQ(told.places[0].kind, PlaceKind::flange);
  ASSERT_EQ(told.numbers.size(), 1);
  EXPECT_EQ(told.numbers[0].name, "t");
}

TEST(NumberText, ShowsNoMinusZeroAndNoExponentInTheRangeOfShops) {
  EXPECT_EQ(number_text(0.0), "0");
  EXPECT_EQ(number_text(-0.0), "0");
  EXPECT_EQ(number_text(0.001), "0.001");
  EXPECT_EQ(number_text(12345.6), "12350");
  EXPECT_EQ(number_text(99994.0), "99994");
  EXPECT_EQ(number_text(120000.0), "120000");
  EXPECT_EQ(number_text(104063.2), "104100");
  EXPECT_EQ(number_text(1e-5), "1e-05");
  EXPECT_EQ(number_text(-2.5), "-2.5");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "inf");
}

TEST(Listed, SetsAndBeforeTheLast) {
  const std::array<std::string, 3> words{"a", "b", "c"};
  EXPECT_EQ(listed(words), "a, b and c");
  EXPECT_EQ(listed(std::span(words).first(2)), "a and b");
  EXPECT_EQ(listed(std::span(words).first(1)), "a");
  EXPECT_EQ(listed({}), "");
}

}  // namespace
}  // namespace planish
