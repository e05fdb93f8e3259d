#include <planish/base/packed_error.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace planish {
namespace {

Error full_error() {
  Error error{code::radius_too_small, "Bend B1 is too tight", "bend B1"};
  error.places = {place::bend("B1"), place::face(7), place::edge(21, {7, 9}),
                  Place{PlaceKind::point, {}, {0.1, -2.5, 1e-300}}};
  error.numbers = {{"radius", {1.0 / 3.0, unit::mm}}, {"count", {3.0, unit::none}}};
  error.remedies = {{"relief", "square", "Cut a square relief"}, {"", "", "draw it wider"}};
  error.remedies[1].named = {{0, "2 mm", {}, {}, Quantity{2.0, unit::mm}, 4, false}};
  error.named = {{5, "B1", {}, place::bend("B1")}, {11, "tight", "relief", {}}};
  return error;
}

TEST(PackedErrors, ComeBackWhole) {
  const auto back = unpacked(packed(full_error()));
  ASSERT_TRUE(back);
  const Error error = full_error();
  EXPECT_EQ(back->code, error.code);
  EXPECT_EQ(exit_status(back->code), exit_status(error.code));
  EXPECT_EQ(back->message, error.message);
  EXPECT_EQ(back->where, error.where);
  EXPECT_EQ(back->places, error.places);
  EXPECT_EQ(back->remedies, error.remedies);
  EXPECT_EQ(back->named, error.named);
  ASSERT_EQ(back->numbers.size(), 2);
  EXPECT_EQ(back->numbers[0].name, "radius");
  EXPECT_EQ(back->numbers[0].quantity, error.numbers[0].quantity);
}

TEST(PackedErrors, KeepTheirWordsWhenTheTextsAreGone) {
  std::optional<Error> back;
  {
    std::vector<std::string> texts = packed(full_error());
    back = unpacked(texts);
    for (std::string& text : texts)
      text.assign(text.size(), '?');
  }
  ASSERT_TRUE(back);
  EXPECT_EQ(back->code.name, "radius_too_small");
  EXPECT_EQ(back->numbers[0].quantity.unit, "mm");
}

TEST(PackedErrors, AreNoneWhenCutShortOrLengthened) {
  const std::vector<std::string> texts = packed(full_error());
  for (std::size_t count = 0; count < texts.size(); ++count)
    EXPECT_FALSE(unpacked(std::span(texts).first(count))) << count;
  std::vector<std::string> longer = texts;
  longer.emplace_back("more");
  EXPECT_FALSE(unpacked(longer));
}

TEST(PackedErrors, AreNoneWhenALengthOrKindIsNoNumber) {
  std::vector<std::string> texts = packed(full_error());
  texts[5] = "many";
  EXPECT_FALSE(unpacked(texts));
  texts = packed(full_error());
  texts[6] = "99";
  EXPECT_FALSE(unpacked(texts));
}

}  // namespace
}  // namespace planish
