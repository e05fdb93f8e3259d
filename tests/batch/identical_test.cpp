#include "identical.hpp"

#include "batch/batch_folder.hpp"

#include <gtest/gtest.h>

namespace planish::batch {
namespace {

class Identical : public test::BatchFolder {
 protected:
  /// Enters parts of one piece each and asks for their numbers.
  std::vector<int> numbers_of(const std::vector<std::vector<FlatPattern>>& parts) {
    auto journal = Journal::open(folder_ / "journal.jsonl");
    EXPECT_TRUE(journal);
    IdenticalParts identical(*journal);
    std::vector<int> numbers;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      std::vector<std::string> shapes;
      for (const FlatPattern& flat : parts[i])
        shapes.push_back(flat_json(flat));
      const PartDone part = part_done(std::to_string(i), "{}", shapes, {});
      EXPECT_TRUE(journal->add(part.record.folder, "k", {part}));
      const auto number = identical.number_of(part.record.folder, 0, part.record.shapes);
      EXPECT_TRUE(number);
      numbers.push_back(number && *number ? static_cast<int>(**number) : -1);
    }
    count_ = identical.count();
    return numbers;
  }
  std::size_t count_ = 0;
};

FlatPattern turned(FlatPattern flat) {
  for (Curve2& curve : flat.outer.loop) {
    auto& side = std::get<Segment>(curve);
    const auto turn = [](const Vec2& p) { return Vec2(-p.y() + 500, p.x() - 3); };
    side = {turn(side.a), turn(side.b)};
  }
  return flat;
}

TEST_F(Identical, PartsHaveOneNumberHoweverTheyLie) {
  const FlatPattern plate = test::flat_plate(100, 60);
  FlatPattern thicker = plate;
  thicker.thickness = 3.0;
  EXPECT_EQ(numbers_of({{plate}, {test::flat_plate(100, 61)}, {plate}, {turned(plate)}, {thicker}}),
            (std::vector<int>{0, 1, 0, 0, 2}));
  EXPECT_EQ(count_, 3u);
}

TEST_F(Identical, RefusedPartsHaveNone) {
  EXPECT_EQ(numbers_of({{}, {test::flat_plate(100, 60)}, {}}), (std::vector<int>{-1, 0, -1}));
  EXPECT_EQ(count_, 1u);
}

TEST_F(Identical, PartsOfSeveralPiecesAreThoseOfTheSamePieces) {
  const FlatPattern a = test::flat_plate(100, 60), b = test::flat_plate(50, 20);
  EXPECT_EQ(numbers_of({{a, b}, {b, a}, {a}, {a, a}, {a, b, b}}),
            (std::vector<int>{0, 0, 1, 2, 3}));
}

TEST_F(Identical, DamagedShapesAreAnError) {
  auto journal = Journal::open(folder_ / "journal.jsonl");
  ASSERT_TRUE(journal);
  IdenticalParts identical(*journal);
  const auto number = identical.number_of("p.step", 0, {"{}"});
  ASSERT_FALSE(number);
  EXPECT_EQ(number.error().code, code::cannot_read);
  EXPECT_EQ(number.error().where, "p.step");
}

}  // namespace
}  // namespace planish::batch
