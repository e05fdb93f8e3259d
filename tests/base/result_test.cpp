#include <planish/base/result.hpp>

#include <gtest/gtest.h>

#include <string>

namespace planish {
namespace {

constexpr Refusal kTooTight{code::radius_too_small,
                            "{@bend} has a radius of {radius}, less than {least}.",
                            "Give it a larger radius."};

Result<int> too_tight() {
  return fail(kTooTight, {{"bend", place::bend("B2")},
                          {"radius", 0.5, unit::mm},
                          {"least", 1.25, unit::mm},
                          {"field", place::pointer("/bends/1")}});
}

TEST(Fail, MakesTheSentenceFromTheFacts) {
  EXPECT_EQ(too_tight().error().message,
            "Bend B2 has a radius of 0.5 mm, less than 1.25 mm. Give it a larger radius.");
}

TEST(Fail, KeepsTheFactsAsData) {
  const auto failed = too_tight();
  const Error& error = failed.error();
  EXPECT_EQ(error.code, code::radius_too_small);
  ASSERT_EQ(error.places.size(), 2);
  EXPECT_EQ(error.places[0], place::bend("B2"));
  ASSERT_EQ(error.numbers.size(), 2);
  EXPECT_EQ(error.numbers[1].name, "least");
  EXPECT_EQ(error.numbers[1].quantity, (Quantity{1.25, unit::mm}));
  ASSERT_EQ(error.remedies.size(), 1);
  EXPECT_EQ(error.remedies[0], (Remedy{"", "", "Give it a larger radius."}));
}

TEST(Fail, NamesTheOptionThatHelpsWithItsValue) {
  constexpr Refusal kClosed{code::unsupported_shape, "The tube is closed.", "Rip {@edge}.",
                            "rip_edges", "{number}"};
  const Result<void> failed = fail(kClosed, {{"edge", place::edge(21)}, {"number", 21}});
  EXPECT_EQ(failed.error().message, "The tube is closed. Rip edge 21.");
  ASSERT_EQ(failed.error().remedies.size(), 1);
  EXPECT_EQ(failed.error().remedies[0],
            (Remedy{"rip_edges", "21", "Rip edge 21.", {{4, "edge 21", {}, place::edge(21)}}}));
}

TEST(InUnits, AnErrorAndItsRemedySpeakInInches) {
  constexpr Refusal kLow{code::unsupported_shape, "{@bend} is {high} high.", "Give it {least}."};
  const Result<void> failed = fail(
      kLow, {{"bend", place::bend("B1")}, {"high", 5.08, unit::mm}, {"least", 25.4, unit::mm}});
  Error error = in_units(failed.error(), LengthUnit::inch);
  EXPECT_EQ(error.message, "Bend B1 is 0.2 in high. Give it 1 in.");
  EXPECT_EQ(error.remedies[0].change, "Give it 1 in.");
  EXPECT_EQ(error.numbers[0].quantity, (Quantity{5.08, unit::mm})) << "data stay in mm";
  say_before(error, failed.error().message + " ");
  EXPECT_EQ(in_units(error, LengthUnit::m).message,
            "Bend B1 is 5.08 mm high. Give it 25.4 mm. Bend B1 is 0.00508 m high. Give it 0.0254 "
            "m.")
      << "what is only text stays";
  EXPECT_EQ(in_units(in_units(error, LengthUnit::inch), LengthUnit::m).message,
            in_units(error, LengthUnit::m).message);
}

TEST(Fail, SaysWhereByAPointerIfThereIsOne) { EXPECT_EQ(too_tight().error().where, "/bends/1"); }

TEST(Fail, SaysWhereByThePlacesOtherwise) {
  constexpr Refusal kApart{code::unsupported_shape, "{@face} are apart"};
  const Result<void> failed = fail(kApart, {{"face", place::face(3)}, {"face", place::face(5)}});
  EXPECT_EQ(failed.error().message, "Faces 3 and 5 are apart");
  EXPECT_EQ(failed.error().where, "face 3 and face 5");
}

/// The pieces joined, options and places marked: "In <face 3>, set <relief|`relief`>."
std::string marked(const Error& error) {
  std::string text;
  for (const Piece& piece : wording(error)) {
    const std::string name = !piece.option.empty() ? piece.option
                             : piece.place         ? text_of(*piece.place)
                                                   : "";
    text += name.empty() ? piece.text : "<" + name + "|" + piece.text + ">";
  }
  return text;
}

constexpr Refusal kUnrelieved{code::unsupported_shape, "{@face} meets {@bend} in {@corner}.",
                              "Set `relief` or `{other}`; see `planish info --sheets`."};

Error unrelieved() {
  return error_of(kUnrelieved, {{"face", place::face(3)},
                                {"bend", place::bend("B1")},
                                {"corner", place::face(4)},
                                {"corner", place::face(5)},
                                {"other", "bend_relief"}});
}

TEST(Wording, TellsOptionsAndSinglePlacesApart) {
  EXPECT_EQ(unrelieved().message,
            "Face 3 meets bend B1 in faces 4 and 5. Set `relief` or `bend_relief`; see `planish "
            "info --sheets`.");
  EXPECT_EQ(marked(unrelieved()),
            "<face 3|Face 3> meets <bend B1|bend B1> in faces 4 and 5. Set <relief|`relief`> or "
            "<bend_relief|`bend_relief`>; see `planish info --sheets`.");
}

TEST(Wording, StaysRightWithTextsBeforeAndBehind) {
  Error error = unrelieved();
  say_before(error, "part.step, ");
  Error more = error_of(Refusal{code::internal, "Or {@face}."}, {{"face", place::face(9)}});
  say_after(error, more);
  EXPECT_EQ(marked(error), "part.step, " + marked(unrelieved()) + " Or <face 9|face 9>.");
}

TEST(Wording, IsPlainTextOnceTheMessageIsAnother) {
  Error error = unrelieved();
  error.message = "It failed.";
  EXPECT_EQ(marked(error), "It failed.");
  error.message.clear();
  EXPECT_TRUE(wording(error).empty());
}

TEST(PassOn, HandsTheErrorToAResultOfAnotherType) {
  const auto handed = []() -> Result<std::string> {
    auto failed = too_tight();
    return pass_on(failed);
  }();
  ASSERT_FALSE(handed);
  EXPECT_EQ(handed.error().code, code::radius_too_small);
  EXPECT_EQ(handed.error().places.size(), 2);
}

TEST(ErrorCodes, AreTheSameIfTheirNamesAre) {
  EXPECT_EQ(code::internal, (ErrorCode{"internal", ExitStatus::refused}));
  EXPECT_NE(code::internal, code::cancelled);
  EXPECT_EQ(exit_status(code::bad_option), 2);
  EXPECT_EQ(exit_status(code::cannot_read), 3);
  EXPECT_EQ(exit_status(code::unsupported_shape), 4);
  EXPECT_EQ(exit_status(code::internal), 1);
}

}  // namespace
}  // namespace planish
