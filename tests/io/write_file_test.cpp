#include "dxf_reading.hpp"

#include <planish/io/flat_writers.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace planish {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class WriteFile : public testing::Test {
 protected:
  fs::path in(const std::string& name) const { return directory_.path() / name; }

  static std::string content(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(directory_.path()), fs::directory_iterator()));
  }

 private:
  sample::Directory directory_{"write-file"};
};

TEST_F(WriteFile, WritesEveryByteAndLeavesNothingElse) {
  const std::string bytes("a\0b\r\n\xff", 6);
  ASSERT_TRUE(write_file(in("part.dxf"), bytes));
  EXPECT_EQ(content(in("part.dxf")), bytes);
  EXPECT_EQ(files(), 1U);
}

TEST_F(WriteFile, ReplacesAFileAndKeepsItsPermissions) {
  ASSERT_TRUE(write_file(in("part.dxf"), "a long first version"));
  const fs::perms shared = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read;
  fs::permissions(in("part.dxf"), shared);
  ASSERT_TRUE(write_file(in("part.dxf"), "short"));
  EXPECT_EQ(content(in("part.dxf")), "short");
  EXPECT_EQ(fs::status(in("part.dxf")).permissions(), shared);
  EXPECT_EQ(files(), 1U);
}

TEST_F(WriteFile, WritesANameAsLongAsTheSystemAllows) {
  const std::string name(255, 'n');
  ASSERT_TRUE(write_file(in(name), "x"));
  EXPECT_EQ(content(in(name)), "x");
}

TEST_F(WriteFile, FollowsASymbolicLink) {
  ASSERT_TRUE(write_file(in("real.dxf"), "old"));
  fs::create_symlink(in("real.dxf"), in("link.dxf"));
  ASSERT_TRUE(write_file(in("link.dxf"), "new"));
  EXPECT_TRUE(fs::is_symlink(in("link.dxf")));
  EXPECT_EQ(content(in("real.dxf")), "new");
}

TEST_F(WriteFile, DoesNotReplaceADevice) {
  ASSERT_TRUE(write_file("/dev/null", "x"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(WriteFile, NamesAMissingDirectory) {
  const auto written = write_file(in("missing") / "part.dxf", "x");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, code::cannot_write);
  EXPECT_THAT(written.error().message, HasSubstr("part.dxf: No such file or directory"));
  EXPECT_EQ(written.error().where, (in("missing") / "part.dxf").string());
}

TEST_F(WriteFile, RefusesADirectory) {
  fs::create_directory(in("folder"));
  const auto written = write_file(in("folder"), "x");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, code::cannot_write);
  EXPECT_THAT(written.error().message, HasSubstr("Is a directory"));
  EXPECT_EQ(files(), 1U);
}

TEST_F(WriteFile, RefusesAnEmptyName) {
  const auto written = write_file("", "x");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, code::cannot_write);
}

TEST_F(WriteFile, TellsAFullDevice) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const auto written = write_file("/dev/full", "x");
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, HasSubstr("No space left on device"));
}

TEST_F(WriteFile, WritesAllFilesOrNone) {
  ASSERT_TRUE(write_file(in("a.dxf"), "old"));
  fs::create_directory(in("folder"));
  const auto written = write_files(
      {{in("a.dxf"), "new"}, {in("b.svg"), "new"}, {in("folder"), ""}});
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().where, in("folder").string());
  EXPECT_EQ(content(in("a.dxf")), "old");
  EXPECT_EQ(files(), 2U);
  ASSERT_TRUE(write_files({{in("a.dxf"), "new"}, {in("b.svg"), "svg"}}));
  EXPECT_EQ(content(in("a.dxf")), "new");
  EXPECT_EQ(content(in("b.svg")), "svg");
  EXPECT_EQ(files(), 3U);
}

TEST_F(WriteFile, WritesNothingBesideAFullDevice) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  EXPECT_FALSE(write_files({{in("a.dxf"), "new"}, {"/dev/full", "x"}}));
  EXPECT_EQ(files(), 0U);
}

TEST_F(WriteFile, SaysBeforehandWhatCannotBeWritten) {
  fs::create_directory(in("folder"));
  EXPECT_THAT(check_writable(in("folder")).error().message, HasSubstr("Is a directory"));
  EXPECT_THAT(check_writable(in("none") / "a.dxf").error().message, HasSubstr("No such file"));
  EXPECT_TRUE(check_writable(in("a.dxf")));
  EXPECT_TRUE(check_writable("/dev/null"));
  EXPECT_EQ(files(), 1U);
}

TEST_F(WriteFile, LeavesAFileAloneThatMayNotBeWritten) {
  ASSERT_TRUE(write_file(in("part.dxf"), "old"));
  fs::permissions(in("part.dxf"), fs::perms::owner_read);
  if (std::ofstream(in("part.dxf"), std::ios::app)) {
    GTEST_SKIP() << "this user may write everything";
  }
  const auto written = write_file(in("part.dxf"), "new");
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, HasSubstr("Permission denied"));
  EXPECT_EQ(content(in("part.dxf")), "old");
  EXPECT_EQ(files(), 1U);
}

}  // namespace
}  // namespace planish
