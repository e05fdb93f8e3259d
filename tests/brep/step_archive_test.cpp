#include "packed_bytes.hpp"
#include "support/test_folder.hpp"

#include <planish/brep/codes.hpp>
#include <planish/brep/step.hpp>
#include <planish/brep/step_archive.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace planish {
namespace {

namespace fs = std::filesystem;
using planish::test::gzipped, planish::test::zipped;

class StepArchive : public ::testing::Test {
 protected:
  fs::path write(const std::string& name, const std::string& bytes) const {
    return folder_.write(name, bytes);
  }
  const test::TestFolder folder_;
  const std::string kStep = "ISO-10303-21; END-ISO-10303-21;";
};

TEST_F(StepArchive, HoldsFilesByTheirPaths) {
  const fs::path zip = write("two.zip", zipped({{"sub/a.step", kStep}, {"b.STP", kStep + " "}}));
  EXPECT_EQ(step_files_in(zip), (std::vector{zip / "sub/a.step", zip / "b.STP"}));
  EXPECT_TRUE(is_in_archive(zip / "b.STP"));
  EXPECT_EQ(read_in_archive(zip / "b.STP"), kStep + " ");
  EXPECT_EQ(read_in_archive(zip / "c.STP").error().code, code::cannot_read);
  EXPECT_FALSE(is_in_archive(zip));
  EXPECT_FALSE(is_in_archive(folder_ / "absent/b.STP"));
  EXPECT_FALSE(is_in_archive(write("plain.zip", "PK") / "b.STP"));
}

TEST_F(StepArchive, OfOneFileIsThatFile) {
  const std::string zip = zipped({{"a.step", kStep}});
  for (const std::string& bytes :
       {zip, gzipped(kStep), gzipped("\xEF\xBB\xBF " + kStep), zip.substr(0, zip.size() / 2),
        gzipped(kStep).substr(0, gzipped(kStep).size() - 4)}) {
    const fs::path file = write("one", bytes);
    EXPECT_EQ(step_files_in(file), std::vector{file}) << "also where it is cut short";
  }
}

TEST_F(StepArchive, MayHoldNone) {
  EXPECT_EQ(step_files_in(write("a", zipped({{"a.txt", "x"}, {"b.txt", kStep}})))->size(), 0u);
  EXPECT_EQ(step_files_in(write("b", zipped({{"a.txt", "x"}})))->size(), 0u);
  EXPECT_EQ(step_files_in(write("c", gzipped("notes")))->size(), 0u);
  EXPECT_FALSE(step_files_in(write("d", kStep)));
  EXPECT_FALSE(step_files_in(write("e", "")));
  EXPECT_FALSE(step_files_in(folder_ / "absent"));
  EXPECT_FALSE(step_files_in(folder_.path()));
}

TEST_F(StepArchive, OfSeveralFilesNamesOneAsItCanBeGiven) {
  const fs::path zip = write("several.zip", zipped({{"sub/a.step", kStep}, {"b.step", kStep}}));
  const auto read = read_step(zip);
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, ::testing::HasSubstr((zip / "sub/a.step").string()));
}

}  // namespace
}  // namespace planish
