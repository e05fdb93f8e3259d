#include <planish/base/result.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

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
  EXPECT_EQ(failed.error().remedies[0], (Remedy{"rip_edges", "21", "Rip edge 21."}));
}

TEST(Fail, SaysWhereByAPointerIfThereIsOne) { EXPECT_EQ(too_tight().error().where, "/bends/1"); }

TEST(Fail, SaysWhereByThePlacesOtherwise) {
  constexpr Refusal kApart{code::unsupported_shape, "{@face} are apart"};
  const Result<void> failed = fail(kApart, {{"face", place::face(3)}, {"face", place::face(5)}});
  EXPECT_EQ(failed.error().message, "Faces 3 and 5 are apart");
  EXPECT_EQ(failed.error().where, "face 3 and face 5");
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
