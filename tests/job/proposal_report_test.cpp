#include "proposal_report.hpp"

#include "job/planned_reports.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace planish::job {
namespace {

using schema::Json;
using test::infeasible_report;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using Kind = Proposal::Kind;

/// A proposal of each kind, with what its kind has.
std::vector<Proposal> one_of_each() {
  std::vector<Proposal> all;
  const auto add = [&](Kind kind) -> Proposal& { return all.emplace_back(Proposal{.kind = kind}); };
  Proposal& smaller = add(Kind::smaller_v);
  smaller.opening = 10.16;
  smaller.tools = {"V10-88", "V10-85"};
  add(Kind::punch).tools = {"P200"};
  add(Kind::taller_punches).by = 50.8;
  Proposal& shorter = add(Kind::shorter_flange);
  shorter.flanges = {FlangeId{4}};
  shorter.by = 12.7;
  Proposal& longer = add(Kind::longer_flanges);
  longer.flanges = {FlangeId{0}, FlangeId{2}};
  longer.by = 2.54;
  add(Kind::swap).bends = {BendId{1}, BendId{0}};
  add(Kind::any_order);
  add(Kind::split).bends = {BendId{1}};
  add(Kind::rolled).bends = {BendId{0}, BendId{1}};
  return all;
}

TEST(ProposalReport, HasTheKeysOfEachKind) {
  Report report = infeasible_report();
  report.plan->proposals = one_of_each();
  report.units = LengthUnit::inch;
  Json rows = proposals_json(*report.plan, report);
  EXPECT_FALSE(schema::first_mistake(schema::list(proposal_schema()), rows));
  std::set<std::string> sentences;
  for (Json& row : rows) {
    sentences.insert(row["sentence"].get<std::string>());
    row.erase("sentence");
  }
  EXPECT_EQ(sentences.size(), rows.size()) << "each is another one";
  EXPECT_EQ(rows,
            Json::parse(R"([{"kind": "smaller_v", "opening": 0.4, "tools": ["V10-88", "V10-85"]},
                                  {"kind": "punch", "tools": ["P200"]},
                                  {"kind": "taller_punches", "by": 2.0},
                                  {"kind": "shorter_flange", "by": 0.5, "flange": "F5"},
                                  {"kind": "longer_flanges", "by": 0.1, "flanges": ["F1", "F3"]},
                                  {"kind": "swap", "bends": ["B2", "B1"]},
                                  {"kind": "any_order"},
                                  {"kind": "split", "bends": ["B2"]},
                                  {"kind": "rolled", "bends": ["B1", "B2"]}])"));
}

TEST(ProposalReport, NamesToolsLengthsFlangesAndBends) {
  const Report report = infeasible_report();
  const auto all = one_of_each();
  const auto said = [&](std::size_t i) { return proposal_sentence(all[i], report); };
  EXPECT_THAT(said(0), AllOf(HasSubstr("10.16 mm"), HasSubstr("V10-88, V10-85")));
  EXPECT_THAT(said(1), HasSubstr("P200"));
  EXPECT_THAT(said(2), HasSubstr("50.8 mm"));
  EXPECT_THAT(said(3), AllOf(HasSubstr("F5"), HasSubstr("12.7 mm")));
  EXPECT_THAT(said(4), AllOf(HasSubstr("F1 and F3"), HasSubstr("2.54 mm")));
  EXPECT_THAT(said(5), AllOf(HasSubstr("B2"), HasSubstr("B1")));
  EXPECT_THAT(said(7), AllOf(HasSubstr("B2"), Not(HasSubstr("B1"))));
}

TEST(ProposalReport, IsARemedyEach) {
  const Report report = infeasible_report();
  const auto remedies = remedies_of(one_of_each(), report);
  ASSERT_EQ(remedies.size(), 9U);
  EXPECT_EQ(remedies[0],
            (Remedy{"opening", "10.16", "Bend it over a V of 10.16 mm (V10-88, V10-85)"}));
  EXPECT_EQ(remedies[7], (Remedy{{}, {}, "Bend it as two parts, cut at B2"}));
  EXPECT_EQ(remedies[8], (Remedy{"large_radii", "roll", "Bend it with B1 and B2 rolled"}));
}

/// The first change is said first; no option of one of them does by itself.
TEST(ProposalReport, SaysBothOfTwoChanges) {
  Report report = infeasible_report();
  Proposal both{.kind = Kind::short_punch, .by = 3.0};
  both.also = {{.kind = Kind::punch, .tools = {"P88"}, .ears = true}};
  report.plan->proposals = {both};
  EXPECT_EQ(proposal_sentence(both, report),
            "with ears for punch P88 and with the punch up to 3 mm short of each end of a bend");
  EXPECT_TRUE(remedies_of({both}, report).front().option.empty());
  const Json rows = proposals_json(*report.plan, report);
  EXPECT_FALSE(schema::first_mistake(schema::list(proposal_schema()), rows));
  EXPECT_EQ(
      rows[0]["also"],
      Json::parse(R"([{"kind": "punch", "sentence": "with ears for punch P88", "tools": ["P88"],
                                              "ears": true}])"));
}

TEST(ProposalReport, TellsHowHighAPunchHasToBe) {
  const Report report = infeasible_report();
  Proposal taller{.kind = Kind::taller_punches, .by = 30.0, .height = 150.0, .tools = {"P88"}};
  EXPECT_EQ(proposal_sentence(taller, report),
            "with punch P88 150 mm high instead of 120 mm, and the upper beam higher by the same");
  taller.height = 0.0;
  taller.tools = {};
  EXPECT_THAT(proposal_sentence(taller, report), HasSubstr("all punches 30 mm taller"));
}

TEST(ProposalReport, IsALineEachOnTheTerminal) {
  Report report = infeasible_report();
  report.plan->proposals = one_of_each();
  const std::string text = proposals_text(*report.plan, report);
  EXPECT_EQ(std::ranges::count(text, '\n'), 1 + 9);
  for (const Proposal& one : report.plan->proposals)
    EXPECT_THAT(text, HasSubstr("  " + proposal_sentence(one, report) + "\n"));
  report.plan->proposals.clear();
  EXPECT_EQ(proposals_text(*report.plan, report), "");
}

TEST(BlockedBend, SaysWhatHitsWhatWhereAndHowDeep) {
  Report report = infeasible_report();
  BlockedBend blocked = report.plan->blocked.front();
  const auto said = [&] { return told_of(blocked, report).sentence; };
  EXPECT_THAT(said(), AllOf(HasSubstr("B2"), HasSubstr("flange 4"), HasSubstr("punch P88"),
                            HasSubstr("3.175 mm"), HasSubstr("72°")));
  report.units = LengthUnit::inch;
  EXPECT_THAT(said(), HasSubstr("0.125 in"));
  blocked.with.reset();
  blocked.at_turn.reset();
  EXPECT_THAT(said(), AllOf(Not(HasSubstr("flange")), Not(HasSubstr("°")), HasSubstr("punch P88")));
  blocked.depth = 0.0;
  EXPECT_EQ(said(), "B2: the part comes nearer to punch P88 than the clearance");
  blocked.why = Remark{"short_side", tell("no V is wide enough", {})};
  EXPECT_THAT(said(), AllOf(HasSubstr("punch P88"), HasSubstr("no V is wide enough")));
  blocked.hits.reset();
  EXPECT_EQ(said(), "B2: no V is wide enough");
}

TEST(BlockedBend, HasAsDataWhatItSays) {
  const Report report = infeasible_report();
  const Told told = told_of(report.plan->blocked.front(), report);
  EXPECT_EQ(told.places, (std::vector<Place>{place::bend("B2"), place::flange(4)}));
  ASSERT_EQ(told.numbers.size(), 2u);
  EXPECT_EQ(told.numbers[0].quantity, (Quantity{3.175, unit::mm}));
  EXPECT_EQ(told.numbers[1].quantity, (Quantity{72.0, unit::degrees}));
  std::string whole;
  std::vector<Place> named;
  for (const Piece& piece : wording(told)) {
    whole += piece.text;
    if (piece.place) named.push_back(*piece.place);
  }
  EXPECT_EQ(whole, told.sentence);
  EXPECT_EQ(named, told.places);
  Report inches = infeasible_report();
  inches.units = LengthUnit::inch;
  const Told same = told_of(inches.plan->blocked.front(), inches);
  EXPECT_EQ(same.numbers[0].quantity, told.numbers[0].quantity);
}

}  // namespace
}  // namespace planish::job
