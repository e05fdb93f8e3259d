// What a batch has done outlives whatever ends the program.

#include "journal.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace planish::batch {
namespace {

namespace fs = std::filesystem;

class JournalFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              ("planish-" +
               std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path file() const { return folder_ / "journal.jsonl"; }
  Journal opened() const {
    auto journal = Journal::open(file());
    EXPECT_TRUE(journal);
    return std::move(*journal);
  }

  fs::path folder_;
};

PartDone part(const std::string& folder, const std::string& report) {
  return part_done(folder, report, {R"({"x":0.1})", "not json"},
                   {{"a.dxf", "bytes"}, {"b.svg", "bytes"}});
}

// Names of files are any bytes but the end of a line of a list.
const std::string kOddName = "a \"b\"\t\\c ü.step";

TEST_F(JournalFile, GivesBackWhatItWasTold) {
  {
    Journal journal = opened();
    ASSERT_TRUE(
        journal.add(kOddName, "k1", {part("f/1", R"({"n":1})"), part("f/2", R"({"n":2.5})")}));
    ASSERT_TRUE(journal.add("empty", "k2", {}));
  }
  Journal journal = opened();
  EXPECT_EQ(journal.key_of(kOddName), "k1");
  EXPECT_EQ(journal.key_of("unknown"), "");
  EXPECT_EQ(journal.names(), (std::vector<std::string>{kOddName, "empty"}));
  const auto parts = journal.parts_of(kOddName);
  ASSERT_TRUE(parts);
  ASSERT_EQ(parts->size(), 2U);
  EXPECT_EQ((*parts)[1].folder, "f/2");
  EXPECT_EQ((*parts)[1].report, R"({"n":2.5})");
  EXPECT_EQ((*parts)[1].shapes, (std::vector<std::string>{R"({"x":0.1})", "not json"}));
  EXPECT_EQ((*parts)[1].files, (std::vector<std::string>{"a.dxf", "b.svg"}));
}

TEST_F(JournalFile, TheLastLineOfANameCounts) {
  Journal journal = opened();
  ASSERT_TRUE(journal.add("a", "old", {part("a", R"({"n":1})")}));
  ASSERT_TRUE(journal.add("b", "b", {}));
  ASSERT_TRUE(journal.add("a", "new", {part("a", R"({"n":2})")}));
  EXPECT_EQ(journal.key_of("a"), "new");
  EXPECT_EQ(journal.parts_of("a")->front().report, R"({"n":2})");
  Journal again = opened();
  EXPECT_EQ(again.key_of("a"), "new");
  EXPECT_EQ(again.parts_of("a")->front().report, R"({"n":2})");
}

// Wherever a run is cut off: all lines before the cut are there, and more can be added.
TEST_F(JournalFile, IsWholeUpToAnyCut) {
  {
    Journal journal = opened();
    for (const char* name : {"a", "b", "c"})
      ASSERT_TRUE(journal.add(name, name, {part(name, R"({"n":1})")}));
  }
  std::ifstream stream(file(), std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(stream)),
                          std::istreambuf_iterator<char>());
  for (std::size_t cut = 0; cut <= whole.size(); ++cut) {
    std::ofstream(file(), std::ios::binary | std::ios::trunc) << whole.substr(0, cut);
    const auto lines = static_cast<std::size_t>(std::ranges::count(whole.substr(0, cut), '\n'));
    {
      Journal journal = opened();
      ASSERT_EQ(journal.names().size(), lines) << cut;
      ASSERT_TRUE(journal.add("d", "d", {part("d", R"({"n":4})")}));
    }
    Journal journal = opened();
    ASSERT_EQ(journal.names().size(), lines + 1) << cut;
    ASSERT_EQ(journal.parts_of("d")->front().report, R"({"n":4})");
  }
}

TEST_F(JournalFile, TakesOverWhatAnotherHolds) {
  Journal one = opened();
  ASSERT_TRUE(one.add("a", "k", {part("a", R"({"n":1})")}));
  auto other = Journal::open(folder_ / "other.jsonl");
  ASSERT_TRUE(other);
  ASSERT_TRUE(other->add_from(one, "a"));
  EXPECT_EQ(other->key_of("a"), "k");
  EXPECT_EQ(other->parts_of("a")->front().shapes, one.parts_of("a")->front().shapes);
}

TEST_F(JournalFile, SaysWhatIsDamaged) {
  std::ofstream(file()) << R"({"name":"a","key":"k"})"
                        << "\tno json\n"
                        << R"({"name":"b","key":"k"})"
                        << "\t[{\"folder\":\"b\"}]\n";
  Journal journal = opened();
  for (const char* name : {"a", "b"}) {
    const auto parts = journal.parts_of(name);
    ASSERT_FALSE(parts) << name;
    EXPECT_EQ(parts.error().code, code::cannot_read) << name;
  }
  EXPECT_EQ(Journal::read(folder_ / "absent").error().code, code::cannot_read);
}

}  // namespace
}  // namespace planish::batch
