#include "folder.hpp"

#include "support/test_folder.hpp"

#include <gtest/gtest.h>

#include <iterator>

namespace planish::pack {
namespace {

namespace fs = std::filesystem;

class PackFolder : public ::testing::Test {
 protected:
  std::string text_in(const std::string& name) const { return folder_.read("out/" + name); }
  const test::TestFolder folder_;
  const fs::path out_ = folder_ / "out";
};

TEST_F(PackFolder, HasWhatIsAdded) {
  Folder folder(out_);
  ASSERT_TRUE(folder.add("a.dxf", "1"));
  ASSERT_TRUE(folder.add("steel/b.dxf", std::string("\0x", 2)));
  ASSERT_TRUE(folder.finish());
  EXPECT_EQ(text_in("a.dxf"), "1");
  EXPECT_EQ(text_in("steel/b.dxf"), std::string("\0x", 2));
  EXPECT_EQ(folder.files(), (std::vector<fs::path>{"a.dxf", "steel/b.dxf"}));
  EXPECT_EQ(folder.path(), out_);
}

TEST_F(PackFolder, LosesWhatAnEarlierPackLeftButNothingElse) {
  {
    Folder folder(out_);
    ASSERT_TRUE(folder.add("a_x2.dxf", "1"));
    ASSERT_TRUE(folder.add("b.dxf", "2"));
    ASSERT_TRUE(folder.finish());
  }
  std::ofstream(out_ / "mine.txt") << "kept";
  Folder folder(out_);
  ASSERT_TRUE(folder.add("a_x3.dxf", "3"));
  ASSERT_TRUE(folder.add("b.dxf", "4"));
  EXPECT_TRUE(fs::exists(out_ / "a_x2.dxf")) << "until it is whole";
  ASSERT_TRUE(folder.finish());
  EXPECT_FALSE(fs::exists(out_ / "a_x2.dxf"));
  EXPECT_EQ(text_in("a_x3.dxf"), "3");
  EXPECT_EQ(text_in("b.dxf"), "4");
  EXPECT_EQ(text_in("mine.txt"), "kept");
}

TEST_F(PackFolder, KnowsWhatAPackLeftThatWasCutOff) {
  {
    Folder cut(out_);
    ASSERT_TRUE(cut.add("old.dxf", "1"));
  }
  Folder folder(out_);
  ASSERT_TRUE(folder.add("new.dxf", "2"));
  ASSERT_TRUE(folder.finish());
  EXPECT_FALSE(fs::exists(out_ / "old.dxf"));
}

TEST_F(PackFolder, RemovesNothingOutside) {
  const fs::path beside = out_.parent_path() / "planish_pack_beside.txt";
  std::ofstream(beside) << "kept";
  fs::create_directories(out_ / ".planish-pack");
  std::ofstream(out_ / ".planish-pack" / "files") << "../planish_pack_beside.txt\n"
                                                  << beside.string() << "\n";
  Folder folder(out_);
  ASSERT_TRUE(folder.add("a.dxf", "1"));
  ASSERT_TRUE(folder.finish());
  EXPECT_TRUE(fs::exists(beside));
  fs::remove(beside);
}

TEST_F(PackFolder, SaysWhatCannotBeWritten) {
  Folder folder(out_);
  ASSERT_TRUE(folder.add("a", "1"));
  const auto below = folder.add("a/b.dxf", "2");
  ASSERT_FALSE(below) << "below a file";
  EXPECT_EQ(below.error().code, code::cannot_write);
}

}  // namespace
}  // namespace planish::pack
