#include "part_list.hpp"

#include "support/flat_plate.hpp"

#include <planish/batch/part_record.hpp>
#include <planish/io/flat_json.hpp>
#include <planish/shop/part_materials.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace planish::pack {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::ElementsAre;
using testing::IsEmpty;

/// The results of a batch, as one leaves them: files with one body each.
class PackedBatch : public ::testing::Test {
 protected:
  PackedBatch() {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / ".planish-batch");
  }
  ~PackedBatch() override { fs::remove_all(folder_); }

  /// Adds a plate of that length.
  void add(const std::string& name, double length, json said = json::object()) {
    said.update({{"input", name}, {"body", fs::path(name).stem().string()}, {"units", "mm"}});
    const auto record = batch::part_record(name, said.dump(),
                                           {flat_json(test::flat_plate(length, 50.0))}, {});
    std::ofstream(folder_ / ".planish-batch/journal.jsonl", std::ios::app)
        << json{{"name", name}, {"key", "k"}}.dump() << "\t[" << batch::record_text(record)
        << "]\n";
    names_.push_back(name);
  }

  Result<PartList> listed(const job::Request& request, const json& copies = json::object()) const {
    const json run{
        {"shard", {1, 1}},
        {"inputs", names_.size()},
        {"work", ""},
        {"finished", true},
        {"names", names_},
        {"copies", copies},
        {"passed_over",
         {{"count", 1},
          {"files", {{{"file", "x.pdf"}, {"reason", "no_input"}, {"why", "no part"}}}}}}};
    std::ofstream(folder_ / ".planish-batch/run.json") << run.dump();
    return part_list(folder_, request);
  }

  static job::Request with_list(const std::string& rows) {
    job::Request request;
    request.materials = shop::PartMaterials::parse("part;material;density;quantity\n" + rows,
                                                   "m.csv")
                            .value();
    return request;
  }

  std::vector<std::string> names_;
  const fs::path folder_ = fs::path(::testing::TempDir()) /
                           (std::string("planish-packed-") +
                            ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

std::vector<std::string> stems_of(const PartList& list) {
  std::vector<std::string> stems;
  for (const PackPart& part : list.parts)
    stems.push_back(part.stem);
  return stems;
}

TEST_F(PackedBatch, HasPiecesAsOftenAsTheyAreWanted) {
  add("a.step", 100.0, {{"quantity", 4}});
  add("b.step", 100.0);
  add("c.step", 70.0, {{"quantity", 2}});
  const auto list = listed(with_list("c;S235;;9\n"), {{"a.step", 3}});
  ASSERT_TRUE(list) << list.error().message;
  EXPECT_THAT(stems_of(*list), ElementsAre("c_S235_2mm_x9", "a_2mm_x13"))
      << "three times four and one; the list's quantity takes the place of the file's";
  EXPECT_EQ(list->passed_over.count, 1u);
  const auto twice = listed(with_list("c;S235;;9\n"), {{"c.step", 3}});
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().code, code::bad_option);
}

TEST_F(PackedBatch, IsOfTheMaterialThatWasChosen) {
  add("a.step", 100.0, {{"material", "oak"}});
  add("b.step", 90.0, {{"material", "oak"}});
  add("c.step", 80.0);
  job::Request request = with_list("a.STEP;S235;;\nz;brass;;\n");
  auto list = listed(request);
  ASSERT_TRUE(list);
  EXPECT_THAT(stems_of(*list), ElementsAre("a_S235_2mm_x1", "b_oak_2mm_x1", "c_2mm_x1"));
  EXPECT_THAT(list->unused_rows, ElementsAre(3)) << "no part is called z";
  request.material = "DC04";
  list = listed(request);
  EXPECT_THAT(stems_of(*list), ElementsAre("b_DC04_2mm_x1", "c_DC04_2mm_x1", "a_S235_2mm_x1"));
  request.materials.reset();
  list = listed(request);
  EXPECT_EQ(list->groups.size(), 1u);
  EXPECT_THAT(list->unused_rows, IsEmpty());
}

TEST_F(PackedBatch, KnowsWhatAPartCouldBeBentWith) {
  const json cannot{{"code", "cannot_bend"},
                    {"severity", "warning"},
                    {"message", "no order"},
                    {"remedy", {{"change", "Bend it as two parts"}}}};
  json other = cannot;
  other["code"] = "volume_identity";
  add("a.step", 100.0, {{"checks", json::array({cannot})}});
  add("b.step", 90.0, {{"checks", json::array({other})}});
  const auto list = listed({});
  ASSERT_TRUE(list);
  EXPECT_THAT(list->parts.at(0).help, ElementsAre("Bend it as two parts"));
  EXPECT_THAT(list->parts.at(1).help, IsEmpty()) << "it is of no help at the press brake";
}

TEST(KindOf, LeavesOutAMaterialThatIsNotKnown) {
  EXPECT_EQ(kind_of("oak", 2.0000001), "_oak_2mm");
  EXPECT_EQ(kind_of(kUnknown, 1.5), "_1.5mm");
}

TEST_F(PackedBatch, WeighsByTheDensityOfItsMaterial) {
  add("a.step", 100.0,
      {{"material", "oak"}, {"density", 0.7}, {"sheet", {{"mass", 0.007}, {"volume", 1e4}}}});
  const auto mass = [&](const std::string& rows, std::optional<double> for_all = {}) {
    job::Request request = with_list(rows);
    request.density = for_all;
    return listed(request).value().parts.at(0).mass;
  };
  EXPECT_EQ(mass("z;S235;;\n"), 0.007) << "as the batch says";
  EXPECT_NEAR(mass("a;S235;7.85;\n").value(), 0.0785, 1e-12);
  EXPECT_NEAR(mass("a;S235;7.85;\n", 8.0).value(), 0.0785, 1e-12) << "the row goes first";
  EXPECT_NEAR(mass("a;S235;;\n", 8.0).value(), 0.08, 1e-12);
  EXPECT_EQ(mass("a;S235;;\n"), std::nullopt) << "oak is not S235";
  EXPECT_EQ(mass("a;OAK;;\n"), 0.007);
}

}  // namespace
}  // namespace planish::pack
