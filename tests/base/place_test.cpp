#include <planish/base/place.hpp>

#include <gtest/gtest.h>

#include <array>

namespace planish {
namespace {

TEST(PlaceText, IsWhatPeopleCallIt) {
  EXPECT_EQ(text_of(place::face(12)), "face 12");
  EXPECT_EQ(text_of(place::body(1)), "body 1");
  EXPECT_EQ(text_of(place::flange(3)), "flange 3");
  EXPECT_EQ(text_of(place::stroke(4)), "stroke 4");
  EXPECT_EQ(text_of(place::line(7)), "line 7");
  EXPECT_EQ(text_of(place::bend("B2")), "bend B2");
  EXPECT_EQ(text_of(place::plate("floor")), "plate \"floor\"");
  EXPECT_EQ(text_of(place::strip(2)), "strip 3") << "people count from 1";
  EXPECT_EQ(text_of(place::ridge(0)), "ridge 1");
  EXPECT_EQ(text_of(place::pointer("/plates/0")), "/plates/0");
  EXPECT_EQ(text_of(place::edge(21)), "edge 21");
  EXPECT_EQ(text_of(place::edge(21, {7, 9})), "edge 21 between face 7 and face 9");
  EXPECT_EQ(text_of(place::edge(21, {7})), "edge 21") << "an open edge";
}

TEST(PlaceText, OfAPointIsItsCoordinates) {
  EXPECT_EQ(text_of(place::point(std::array{12.5, 40.0})), "(12.5, 40)");
  EXPECT_EQ(text_of(place::point(std::array{-1.0, 0.25, 3.0})), "(-1, 0.25, 3)");
  EXPECT_EQ(text_of(place::point(std::array{12.5, -3e-15, 4e-7})), "(12.5, 0, 0)") << "rounding";
}

TEST(PlaceId, LeavesTheKindAway) {
  EXPECT_EQ(id_text(place::face(12)), "12");
  EXPECT_EQ(id_text(place::strip(2)), "3");
  EXPECT_EQ(id_text(place::plate("floor")), "\"floor\"");
  EXPECT_EQ(id_text(place::bend("B2")), "B2");
  EXPECT_EQ(id_text(place::point(std::array{1.0, 2.0})), "(1, 2)");
}

TEST(PlaceKinds, AreSpelledAsInReports) {
  using enum PlaceKind;
  const std::vector<std::pair<PlaceKind, std::string_view>> names{
      {face, "face"},     {edge, "edge"},   {body, "body"},       {flange, "flange"},
      {bend, "bend"},     {plate, "plate"}, {strip, "strip"},     {ridge, "ridge"},
      {stroke, "stroke"}, {point, "point"}, {pointer, "pointer"}, {line, "line"}};
  for (const auto& [kind, name] : names)
    EXPECT_EQ(kind_name(kind), name);
}

TEST(Places, KeepTheirIdWhenTheyAreTold) {
  const Place told = place::at(place::face(5), std::array{1.0, 2.0, 3.0});
  EXPECT_EQ(std::get<int>(told.id), 5);
  EXPECT_EQ(told.at, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(text_of(told), "face 5");
  EXPECT_FALSE(told == place::face(5));
}

}  // namespace
}  // namespace planish
