#include <planish/job/plates_json.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace planish::job {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// The example of formats.md#plates, with a second plate.
json example() {
  return json::parse(R"({
    "format": "planish/plates", "version": 1, "units": "mm", "thickness": 4.0, "k_factor": 0.4,
    "plates": [
      { "id": "A", "outline": [[0,0,0],[200,0,0],[200,100,0],[0,100,0]],
        "holes": [ [[10,10,0],[20,10,0],[20,20,0]] ] },
      { "id": "B", "outline": [[0,120,20],[200,120,20],[200,120,120],[0,120,120]] } ],
    "bends": [
      { "between": ["A","B"], "edges": { "B": [0], "A": [2,3] }, "surface": "cone",
        "inside_radius": 12.0, "slope": 0.2, "apex": -340.0, "lateral": "straight",
        "trade_off": 1.5, "aperture": 40 } ],
    "root": "A" })");
}

// The example with `value` at a place.
std::string with(const std::string& pointer, const json& value) {
  json changed = example();
  changed[json::json_pointer(pointer)] = value;
  return changed.dump();
}

Error error_of(const std::string& text) {
  const auto read = parse_plates(text, "p.json");
  EXPECT_FALSE(read.has_value()) << text;
  return read ? Error{} : read.error();
}

void expect_mistake(const std::string& pointer, const json& value, const std::string& words) {
  const Error error = error_of(with(pointer, value));
  EXPECT_EQ(error.code, code::invalid_input) << pointer << " " << value;
  EXPECT_EQ(error.where, "p.json" + pointer) << value << " " << error.message;
  ASSERT_FALSE(error.places.empty()) << pointer;
  EXPECT_EQ(error.places[0], place::pointer(pointer));
  EXPECT_THAT(error.message, HasSubstr("plates file: " + pointer + " " + words)) << value;
}

TEST(PlatesJson, ReadsEverythingOfTheExample) {
  const auto read = parse_plates(example().dump(), "p.json");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  const PlateStructure& structure = read->structure;
  EXPECT_EQ(read->units, LengthUnit::mm);
  EXPECT_EQ(read->k_factor, 0.4);
  EXPECT_EQ(structure.thickness, 4.0);
  EXPECT_EQ(structure.root, "A");
  ASSERT_EQ(structure.plates.size(), 2u);
  EXPECT_EQ(structure.plates[0].id, "A");
  ASSERT_EQ(structure.plates[0].outline.size(), 4u);
  EXPECT_EQ(structure.plates[0].outline[2], Vec3(200, 100, 0));
  ASSERT_EQ(structure.plates[0].holes.size(), 1u);
  EXPECT_EQ(structure.plates[0].holes[0][2], Vec3(20, 20, 0));
  ASSERT_EQ(structure.bends.size(), 1u);
  const BendRequest& bend = structure.bends[0];
  EXPECT_THAT(bend.between, ElementsAre("A", "B"));
  ASSERT_TRUE(bend.edges[0] && bend.edges[1]);
  EXPECT_THAT(*bend.edges[0], ElementsAre(2, 3)) << "by plate, not by the order of the file";
  EXPECT_THAT(*bend.edges[1], ElementsAre(0));
  EXPECT_EQ(bend.surface, SurfaceChoice::cone);
  EXPECT_EQ(bend.inside_radius, 12.0);
  EXPECT_EQ(bend.slope, 0.2);
  EXPECT_EQ(bend.apex, -340.0);
  EXPECT_EQ(bend.lateral, LateralBoundary::straight);
  EXPECT_EQ(bend.trade_off, 1.5);
  ASSERT_TRUE(bend.aperture.has_value());
  EXPECT_DOUBLE_EQ(bend.aperture->degrees(), 40.0);
  EXPECT_FALSE(bend.inside_radii || bend.angle || bend.length);
}

TEST(PlatesJson, LeavesWhatIsNotSaidToTheProgram) {
  const auto read = parse_plates(
      R"({"thickness": 1, "plates": [{"id": "A", "outline": []}], "bends": [{"between": ["A"]}]})",
      "p.json");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_FALSE(read->k_factor.has_value());
  EXPECT_EQ(read->structure.root, "");
  const BendRequest& bend = read->structure.bends[0];
  EXPECT_FALSE(bend.edges[0] || bend.edges[1] || bend.inside_radius || bend.slope || bend.apex);
  EXPECT_EQ(bend.surface, SurfaceChoice::automatic);
  EXPECT_EQ(bend.lateral, LateralBoundary::automatic);
  EXPECT_EQ(bend.trade_off, 1.0);
}

TEST(PlatesJson, TurnsLengthsIntoMillimetresAndNothingElse) {
  const struct {
    const char* name;
    LengthUnit unit;
    double millimetres;
  } units[] = {{"inch", LengthUnit::inch, 25.4}, {"m", LengthUnit::m, 1000.0}};
  for (const auto& unit : units) {
    const auto read = parse_plates(with("/units", unit.name), "p.json");
    ASSERT_TRUE(read.has_value()) << read.error().message;
    EXPECT_EQ(read->units, unit.unit);
    const PlateStructure& structure = read->structure;
    EXPECT_DOUBLE_EQ(structure.thickness, 4 * unit.millimetres);
    EXPECT_DOUBLE_EQ(structure.plates[0].outline[1].x(), 200 * unit.millimetres);
    EXPECT_DOUBLE_EQ(structure.plates[0].holes[0][1].y(), 10 * unit.millimetres);
    const BendRequest& bend = structure.bends[0];
    EXPECT_DOUBLE_EQ(*bend.inside_radius, 12 * unit.millimetres);
    EXPECT_DOUBLE_EQ(*bend.apex, -340 * unit.millimetres);
    EXPECT_EQ(bend.slope, 0.2);
    EXPECT_EQ(bend.trade_off, 1.5);
    EXPECT_DOUBLE_EQ(bend.aperture->degrees(), 40.0);
    EXPECT_EQ(read->k_factor, 0.4);
  }
}

TEST(PlatesJson, TakesSectionsWithFreeEndsAndOfTheirOwn) {
  const auto read = parse_plates(R"({"units": "m", "thickness": 0.002, "plates": [], "bends": [
      {"between": [], "surface": "cone", "inside_radii": [0.1, 0.2], "angle": 360,
       "length": 0.5}]})",
                                 "p.json");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  const BendRequest& pipe = read->structure.bends[0];
  EXPECT_THAT(pipe.between, IsEmpty());
  ASSERT_TRUE(pipe.inside_radii && pipe.angle && pipe.length);
  EXPECT_THAT(*pipe.inside_radii, ElementsAre(100.0, 200.0));
  EXPECT_DOUBLE_EQ(pipe.angle->degrees(), 360.0);
  EXPECT_DOUBLE_EQ(*pipe.length, 500.0);
}

TEST(PlatesJson, KnowsAllSurfacesAndBoundaries) {
  const std::vector<std::pair<const char*, SurfaceChoice>> surfaces{
      {"auto", SurfaceChoice::automatic},
      {"cylinder", SurfaceChoice::cylinder},
      {"cone", SurfaceChoice::cone},
      {"general", SurfaceChoice::general}};
  for (const auto& [word, value] : surfaces)
    EXPECT_EQ(parse_plates(with("/bends/0/surface", word), "p")->structure.bends[0].surface, value);
  const std::vector<std::pair<const char*, LateralBoundary>> boundaries{
      {"auto", LateralBoundary::automatic},
      {"straight", LateralBoundary::straight},
      {"arc", LateralBoundary::arc},
      {"corner", LateralBoundary::corner}};
  for (const auto& [word, value] : boundaries)
    EXPECT_EQ(parse_plates(with("/bends/0/lateral", word), "p")->structure.bends[0].lateral, value);
}

TEST(PlatesJson, NamesEveryUnknownKeyByItsPointer) {
  for (const char* pointer :
       {"/thicknes", "/plates/1/outlin", "/plates/0/hole", "/bends/0/betwen", "/bends/0/radius"}) {
    expect_mistake(pointer, 3, "is not a known key. The keys known here are ");
  }
  EXPECT_THAT(error_of(with("/plates/1/outlin", 3)).message, HasSubstr("id, outline, holes"));
}

TEST(PlatesJson, PrefersTheMisspeltKeyToTheMissingOne) {
  json misspelt = example();
  misspelt.erase("thickness");
  EXPECT_EQ(error_of(misspelt.dump()).where, "p.json/thickness");
  EXPECT_THAT(error_of(misspelt.dump()).message, HasSubstr("/thickness is missing"));
  misspelt["thicknes"] = 4;
  EXPECT_EQ(error_of(misspelt.dump()).where, "p.json/thicknes");
}

TEST(PlatesJson, MissesWhatMustBeThere) {
  for (const char* pointer :
       {"/thickness", "/plates", "/plates/0/id", "/plates/1/outline", "/bends/0/between"}) {
    json changed = example();
    const json::json_pointer place(pointer);
    changed[place.parent_pointer()].erase(place.back());
    EXPECT_EQ(error_of(changed.dump()).where, std::string("p.json") + pointer);
  }
}

TEST(PlatesJson, RefusesValuesOfAnotherKind) {
  for (const json& wrong :
       {json("4"), json(nullptr), json(true), json::array({4}), json::object()}) {
    expect_mistake("/thickness", wrong, "must be a number above 0, not ");
    expect_mistake("/k_factor", wrong, "must be a number from 0 to 1, not ");
    expect_mistake("/plates/0/outline/1/2", wrong, "must be a number, not ");
    expect_mistake("/plates/0/holes/0/2/0", wrong, "must be a number, not ");
    expect_mistake("/bends/0/inside_radius", wrong, "must be a number of at least 0, not ");
    expect_mistake("/bends/0/slope", wrong, "must be a number, not ");
    expect_mistake("/bends/0/apex", wrong, "must be a number, not ");
    expect_mistake("/bends/0/trade_off", wrong, "must be a number of at least 0, not ");
    expect_mistake("/bends/0/aperture", wrong, "must be an angle above 0 and below 180");
    expect_mistake("/bends/0/edges/A/1", wrong, "must be a whole number of at least 0, not ");
  }
  for (const json& wrong : {json(4), json(nullptr), json(""), json::array(), json::object()}) {
    expect_mistake("/plates/0/id", wrong, "must be a text that is not empty, not ");
    expect_mistake("/bends/0/between/1", wrong, "must be a text that is not empty, not ");
    expect_mistake("/root", wrong, "must be a text that is not empty, not ");
  }
  for (const char* pointer : {"/plates", "/bends", "/plates/0/outline", "/plates/0/holes",
                              "/bends/0/between", "/bends/0/edges/A"}) {
    for (const json& wrong : {json(4), json("A"), json::object()})
      expect_mistake(pointer, wrong, "must be a list, not ");
  }
  for (const json& wrong : {json(4), json("A")})
    expect_mistake("/plates/0/holes/0", wrong, "must be a list of corners, a circle, a slot or");
  for (const char* pointer : {"/plates/1", "/bends/0", "/bends/0/edges"}) {
    for (const json& wrong : {json(4), json::array()})
      expect_mistake(pointer, wrong, "must be an object, not ");
  }
}

TEST(PlatesJson, RefusesValuesOutOfRange) {
  for (const double wrong : {-4.0, 0.0})
    expect_mistake("/thickness", wrong, "must be a number above 0, not ");
  for (const double wrong : {-0.1, 1.1})
    expect_mistake("/k_factor", wrong, "must be a number from 0 to 1");
  expect_mistake("/bends/0/inside_radius", -1, "must be a number of at least 0, not -1");
  expect_mistake("/bends/0/trade_off", -0.5, "must be a number of at least 0, not -0.5");
  for (const double wrong : {0.0, 180.0, -20.0})
    expect_mistake("/bends/0/aperture", wrong, "must be an angle");
  for (const json& wrong : {json(-1), json(1.5), json(1e12)})
    expect_mistake("/bends/0/edges/A/0", wrong, "must be a whole number of at least 0");
  expect_mistake("/units", "cm", "must be one of mm, inch, m, not \"cm\"");
  expect_mistake("/bends/0/surface", "sphere", "must be one of auto, cylinder, cone, general");
  expect_mistake("/bends/0/lateral", "round", "must be one of auto, straight, arc, corner");
  expect_mistake("/bends/0/surface", 3, "must be one of ");
  for (const json& wrong : {json::parse("[1,2]"), json::parse("[1,2,3,4]"), json(7)})
    expect_mistake("/plates/1/outline/3", wrong, "must be a point [x, y, z], not ");
}

TEST(PlatesJson, RefusesLengthsThatAreNotFiniteInMillimetres) {
  json huge = example();
  huge["units"] = "m";
  huge["thickness"] = 1e308;
  EXPECT_EQ(error_of(huge.dump()).where, "p.json/thickness");
  EXPECT_EQ(error_of("{\"thickness\": 1e999}").code, code::invalid_input);
  EXPECT_EQ(error_of("{\"thickness\": NaN}").code, code::invalid_input);
}

TEST(PlatesJson, RefusesWhatASectionCannotBe) {
  json section = example();
  json& bend = section["bends"][0];
  bend = {{"between", {"A"}}, {"inside_radius", 5}, {"angle", 361}};
  EXPECT_EQ(error_of(section.dump()).where, "p.json/bends/0/angle");
  bend["angle"] = 0;
  EXPECT_EQ(error_of(section.dump()).where, "p.json/bends/0/angle");
  bend["angle"] = 90;
  EXPECT_TRUE(parse_plates(section.dump(), "p.json").has_value());
  bend["inside_radii"] = {5, 6};
  EXPECT_EQ(error_of(section.dump()).where, "p.json/bends/0/inside_radii");
  bend.erase("inside_radius");
  bend["inside_radii"] = {5, 6, 7};
  EXPECT_EQ(error_of(section.dump()).where, "p.json/bends/0/inside_radii");
  bend["inside_radii"] = {5, -6};
  EXPECT_EQ(error_of(section.dump()).where, "p.json/bends/0/inside_radii/1");
  bend["inside_radii"] = {5, 6};
  bend["length"] = 50;
  EXPECT_EQ(error_of(section.dump()).where, "p.json/bends/0/length");
  bend = {{"between", {"A", "B"}}, {"angle", 90}};
  EXPECT_EQ(error_of(section.dump()).where, "p.json/bends/0/angle");
}

TEST(PlatesJson, RefusesBendsAndEdgesThatCannotBeMeant) {
  expect_mistake("/bends/0/between", {"A", "A"}, "names plate \"A\" twice");
  expect_mistake("/bends/0/between", {"A", "B", "C"}, "names 3 plates");
  expect_mistake("/bends/0/edges/C", {1}, "is not a plate of this bend, which has A and B");
  expect_mistake("/bends/0/edges/A", json::array(), "must be a list of at least 1 edge (leave");
  expect_mistake("/bends/0/edges/A/1", 2, "is 2, which is already in the list");
  expect_mistake("/plates/1/id", "A", "is \"A\", and so is the id of /plates/0");
}

TEST(PlatesJson, RefusesAFileOfNothing) {
  EXPECT_EQ(error_of(R"({"thickness": 1, "plates": []})").where, "p.json/plates");
}

TEST(PlatesJson, RefusesOtherFormatsAndVersions) {
  expect_mistake("/format", "planish/rules", "must be \"planish/plates\", not \"planish/rules\"");
  expect_mistake("/version", 2, "must be 1, not 2");
}

TEST(PlatesJson, FindsTheLineAndColumnOfAMistake) {
  const Error error = error_of("{\n  \"thickness\": 4,\n  \"plates\" [] }");
  EXPECT_THAT(error.message,
              HasSubstr("The plates file is not JSON: there is a mistake in line 3, column "));
  EXPECT_EQ(error.places, std::vector<Place>{place::line(3)});
  EXPECT_THAT(error.where, HasSubstr("p.json:3:"));
  for (const char* text : {"", "[]", "3", "null", "{", "\xff"})
    EXPECT_EQ(error_of(text).code, code::invalid_input) << text;
}

TEST(PlatesJson, GivesDefaultsToBendsThatLeaveThemOpen) {
  json file = example();
  file["defaults"] = {{"inside_radius", 3}, {"lateral", "arc"}, {"trade_off", 0.25}};
  file["bends"] = {{{"between", {"A", "B"}}},
                   {{"between", {"A", "B"}}, {"lateral", "auto"}, {"slope", 0.1}},
                   {{"between", {"A", "B"}}, {"inside_radius", 7}, {"trade_off", 1}},
                   {{"between", {"A", "B"}}, {"surface", "general"}}};
  const auto read = parse_plates(file.dump(), "p.json");
  ASSERT_TRUE(read) << read.error().message;
  const std::vector<BendRequest>& bends = read->structure.bends;
  EXPECT_EQ(bends[0].inside_radius, 3.0);
  EXPECT_EQ(bends[0].lateral, LateralBoundary::arc);
  EXPECT_EQ(bends[0].trade_off, 0.25);
  EXPECT_FALSE(bends[1].inside_radius);
  EXPECT_EQ(bends[1].lateral, LateralBoundary::automatic);
  EXPECT_EQ(bends[2].inside_radius, 7.0);
  EXPECT_EQ(bends[2].trade_off, 1.0);
  EXPECT_FALSE(bends[3].inside_radius);
  EXPECT_EQ(error_of(with("/defaults", {{"inside_radius", -1}})).where,
            "p.json/defaults/inside_radius");
}

TEST(PlatesJson, TakesOptionsInsteadOfItsDefaults) {
  json file = example();
  file["defaults"] = {{"inside_radius", 3}, {"lateral", "arc"}, {"trade_off", 0.25}};
  file["largest_span"] = 400;
  file["bends"] = {{{"between", {"A", "B"}}},
                   {{"between", {"A", "B"}}, {"inside_radius", 7}, {"lateral", "corner"}},
                   {{"between", {"A", "B"}}, {"slope", 0.1}, {"trade_off", 2}}};
  const auto read = parse_plates(file.dump(), "p.json");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->structure.largest_span, 400.0);
  const PlateStructure same = with_options(*read, {});
  EXPECT_EQ(same.bends[0].inside_radius, 3.0);
  EXPECT_EQ(same.largest_span, 400.0);

  const PlateStructure other = with_options(*read, {.inside_radius = 5.0,
                                                    .lateral = LateralBoundary::straight,
                                                    .trade_off = 0.5,
                                                    .largest_span = 250.0,
                                                    .trim = false});
  EXPECT_FALSE(same.trim);
  EXPECT_EQ(other.trim, false);
  EXPECT_EQ(other.defaults.inside_radius, 5.0);
  EXPECT_EQ(other.largest_span, 250.0);
  EXPECT_EQ(other.bends[0].inside_radius, 5.0);
  EXPECT_EQ(other.bends[0].lateral, LateralBoundary::straight);
  EXPECT_EQ(other.bends[0].trade_off, 0.5);
  EXPECT_EQ(other.bends[1].inside_radius, 7.0);
  EXPECT_EQ(other.bends[1].lateral, LateralBoundary::corner);
  EXPECT_FALSE(other.bends[2].inside_radius) << "it follows from the slope";
  EXPECT_EQ(other.bends[2].trade_off, 2.0);
  EXPECT_EQ(error_of(with("/largest_span", 0)).where, "p.json/largest_span");
}

TEST(PlatesJson, TakesNoKeyTwice) {
  const Error error = error_of(
      R"({"thickness": 1, "plates": [{"id": "A", "outline": [], "id": "B"}]})");
  EXPECT_EQ(error.code, code::invalid_input);
  EXPECT_THAT(error.message, HasSubstr("\"id\" twice"));
}

TEST(PlatesJson, EscapesKeysInPointersAndKeepsMessagesShort) {
  EXPECT_EQ(error_of(with("/bends/0/edges", {{"a/b~c", {1}}})).where,
            "p.json/bends/0/edges/a~1b~0c");
  EXPECT_LT(error_of(with("/thickness", std::string(100000, 'x'))).message.size(), 200u);
  const auto error_of_nested = [](int depth) {
    return error_of("{\"plates\": [], \"thickness\": " + std::string(depth, '[') +
                    std::string(depth, ']') + "}");
  };
  EXPECT_THAT(error_of_nested(90).message, HasSubstr("not a list"));
  EXPECT_THAT(error_of_nested(200000).message, HasSubstr("nested more than 100 deep"));
}

TEST(ParsePlates, ReadsHolesWithArcsInTheUnitOfTheFile) {
  const auto read = parse_plates(R"({
    "format": "planish/plates", "version": 1, "units": "inch", "thickness": 0.1,
    "plates": [ { "id": "A", "outline": [[0,0,0],[9,0,0],[9,9,0],[0,9,0]],
                  "holes": [ { "circle": { "at": [1,1,0], "radius": 0.5 } },
                             [[3,3,0],[4,3,0],[4,4,0]],
                             { "slot": { "from": [6,1,0], "to": [7,1,0], "width": 0.5 } },
                             { "path": [[2,6,0], { "through": [3,7,0], "to": [4,6,0] }] },
                             { "path": [[6,6,0], [8,6,0],
                                        { "through": [7,7,0], "to": [6,6,0] }] } ] } ],
    "bends": [ { "between": ["A"], "edges": { "A": [0] }, "angle": 90, "inside_radius": 1 } ],
    "trim": true })",
                                 "p.json");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->structure.trim, true);
  const Plate& plate = read->structure.plates.front();
  ASSERT_EQ(plate.holes.size(), 5u);
  EXPECT_EQ(plate.holes[1].size(), 3u);
  ASSERT_EQ(plate.shapes.size(), 4u);
  const auto& round = std::get<RoundHole>(plate.shapes.at(0));
  EXPECT_EQ(round.at, Vec3(25.4, 25.4, 0));
  EXPECT_EQ(round.radius, 12.7);
  EXPECT_EQ(std::get<SlotHole>(plate.shapes.at(2)).width, 12.7);
  // Closed by a straight edge, and by an arc that leads to the first corner.
  const auto& open = std::get<ArcHole>(plate.shapes.at(3));
  EXPECT_EQ(open.corners.size(), 2u);
  EXPECT_TRUE(open.through[0] && !open.through[1]);
  const auto& closed = std::get<ArcHole>(plate.shapes.at(4));
  EXPECT_EQ(closed.corners.size(), 2u);
  EXPECT_TRUE(!closed.through[0] && closed.through[1]);
}

TEST(ParsePlates, RefusesHolesThatAreNoShape) {
  for (const char* hole : {R"({ "circle": { "at": [1,1,0], "radius": 0 } })", R"({ "disc": 1 })",
                           R"({ "slot": { "from": [1,1,0], "to": [2,1,0] } })"}) {
    const auto read = parse_plates(
        std::string(R"({ "format": "planish/plates", "version": 1, "thickness": 1, "plates": [
          { "id": "A", "outline": [[0,0,0],[9,0,0],[9,9,0]], "holes": [)") +
            hole + "] } ] }",
        "p.json");
    ASSERT_FALSE(read) << hole;
    EXPECT_TRUE(read.error().where.starts_with("p.json/plates/0/holes/0")) << read.error().where;
  }
}

}  // namespace
}  // namespace planish::job
