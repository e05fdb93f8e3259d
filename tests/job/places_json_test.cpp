#include "places_json.hpp"

#include <planish/job/reason.hpp>
#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

namespace planish::job {
namespace {

const Units kInMillimetres(LengthUnit::mm), kInInches(LengthUnit::inch);

TEST(PlacesJson, HaveWhatIsKnownOfAPlace) {
  EXPECT_EQ(place_json(place::face(12), kInMillimetres),
            Json::parse(R"({"kind": "face", "id": 12})"));
  EXPECT_EQ(place_json(place::edge(21, {7, 9}), kInMillimetres),
            Json::parse(R"({"kind": "edge", "id": 21, "faces": [7, 9]})"));
  EXPECT_EQ(place_json(place::at(place::bend("B2"), Vec2(25.4, 50.8)), kInInches),
            Json::parse(R"({"kind": "bend", "id": "B2", "at": [1.0, 2.0]})"));
  EXPECT_EQ(place_json(place::point(Vec3(1, 2, 3)), kInMillimetres),
            Json::parse(R"({"kind": "point", "at": [1.0, 2.0, 3.0]})"));
  EXPECT_EQ(places_json({place::strip(0), place::line(7)}, kInMillimetres),
            Json::parse(R"([{"kind": "strip", "id": 0}, {"kind": "line", "id": 7}])"));
}

TEST(PlacesJson, KeepTheUnitThatANumberStates) {
  EXPECT_EQ(numbers_json({{"depth", {25.4, unit::mm}}, {"count", {3.0, unit::none}}}),
            Json::parse(R"({"depth": {"value": 25.4, "unit": "mm"},
                            "count": {"value": 3.0, "unit": ""}})"));
  EXPECT_EQ(numbers_json({}), Json::object());
}

TEST(PlacesJson, SpellRemediesAsTheProgramTakesThem) {
  Json doc = Json::object();
  add_remedies(doc, {});
  EXPECT_TRUE(doc.empty());
  const Remedy rip{"rip_edges", "21,25", ""}, drawn{"", "", "Draw a gap."};
  add_remedies(doc, {rip});
  EXPECT_EQ(doc, Json::parse(R"({"remedy": {"option": "--rip-edges", "value": "21,25"}})"));
  doc = Json::object();
  add_remedies(doc, {rip, drawn});
  EXPECT_EQ(doc["remedy"], doc["remedies"][0]);
  EXPECT_EQ(doc["remedies"][1], Json::parse(R"({"change": "Draw a gap."})"));
  EXPECT_EQ(doc["remedies"].size(), 2u);
}

Finding flange_finding() {
  return {"flange_height", Severity::warning, "too low", {{25.4, 50.8}, {0, 25.4}}};
}

TEST(PlacesJson, OfAFindingAreWhatItIsAboutElseItsPoints) {
  Finding finding = flange_finding();
  Json doc = check_json(finding, kInInches);
  EXPECT_EQ(doc["code"], "flange_height");
  EXPECT_EQ(doc["severity"], "warning");
  EXPECT_EQ(doc["at"], Json::parse("[[1.0, 2.0], [0.0, 1.0]]"));
  EXPECT_EQ(doc["places"], Json::parse(R"([{"kind": "point", "at": [1.0, 2.0]},
                                            {"kind": "point", "at": [0.0, 1.0]}])"));
  EXPECT_FALSE(doc.contains("count"));
  finding.about = {place::flange(3)};
  finding.numbers = {{"height", {12.7, unit::mm}}};
  finding.remedies = {{"relief", "rip", ""}};
  doc = check_json(finding, kInInches);
  EXPECT_EQ(doc["places"], Json::parse(R"([{"kind": "flange", "id": 3}])"));
  EXPECT_EQ(doc["numbers"]["height"]["value"], 12.7);
  EXPECT_EQ(doc["remedy"]["option"], "--relief");
}

TEST(PlacesJson, OfARuleAreAllItsBreaches) {
  Finding finding = flange_finding();
  finding.about = {place::flange(9)};
  finding.places = {{Severity::info,
                     "a little",
                     {{25.4, 0}, {50.8, 0}},
                     {place::bend("B1")},
                     {{"left", {1.0, unit::mm}}}},
                    {Severity::error, "much", {}, {}, {}}};
  const Json doc = check_json(finding, kInInches);
  EXPECT_EQ(doc["count"], 2);
  EXPECT_EQ(doc["places"][0],
            Json::parse(R"({"kind": "bend", "id": "B1", "at": [1.0, 0.0], "severity": "info",
                            "message": "a little", "points": [[1.0, 0.0], [2.0, 0.0]],
                            "numbers": {"left": {"value": 1.0, "unit": "mm"}}})"));
  EXPECT_EQ(doc["places"][1], Json::parse(R"({"kind": "point", "severity": "error",
                                               "message": "much", "points": []})"));
}

TEST(PlacesJson, OfARefusalGoWithItsCode) {
  EXPECT_TRUE(reason_json(std::nullopt, kInMillimetres).is_null());
  Error error{code::overlap,
              "covers \xE4",
              "flange 3",
              {place::at(place::flange(3), Vec2(0, 25.4))},
              {{"depth", {2.0, unit::mm}}},
              {{"relief", "rip", ""}}};
  const Json reason = reason_json(error, kInInches);
  EXPECT_EQ(reason["code"], "overlap");
  EXPECT_EQ(reason["where"], "flange 3");
  EXPECT_EQ(reason["places"][0]["at"], Json::parse("[0.0, 1.0]"));
  EXPECT_EQ(reason["numbers"]["depth"]["unit"], "mm");
  EXPECT_EQ(reason["remedy"]["value"], "rip");
  const std::string text = reason_text(error);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(Json::parse(text)["message"], "covers \uFFFD");
  EXPECT_EQ(Json::parse(text)["places"][0]["at"], Json::parse("[0.0, 25.4]")) << "in mm";
}

TEST(PlacesJson, PassTheirSchemas) {
  const Schema schema = schema::object(place_fields());
  const auto passes = [&](const Place& place) {
    return !schema::first_mistake(schema, place_json(place, kInMillimetres));
  };
  for (int kind = 0; kind <= static_cast<int>(PlaceKind::line); ++kind)
    EXPECT_TRUE(passes({static_cast<PlaceKind>(kind), 1})) << kind;
  EXPECT_TRUE(passes(place::edge(21, {7, 9})));
  EXPECT_TRUE(passes(place::point(Vec2(1, 2))));
  EXPECT_TRUE(passes(place::point(Vec3(1, 2, 3))));
  EXPECT_FALSE(passes({PlaceKind::point, {}, {1.0}}));
  EXPECT_FALSE(passes({PlaceKind::point, {}, {1.0, 2.0, 3.0, 4.0}}));
  EXPECT_FALSE(passes(place::edge(21, {0}))) << "faces count from 1";
  EXPECT_TRUE(passes(place::edge(21, {1})));
  EXPECT_FALSE(schema::first_mistake(numbers_schema(), numbers_json({{"depth", {2.0, unit::mm}}})));
}

}  // namespace
}  // namespace planish::job
