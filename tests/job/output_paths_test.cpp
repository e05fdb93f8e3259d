#include "support/test_folder.hpp"

#include <planish/job/output_paths.hpp>

#include <gtest/gtest.h>

namespace planish::job {
namespace {

namespace fs = std::filesystem;

class OutputPaths : public ::testing::Test {
 protected:
  OutputPaths() { fs::create_directories(folder_ / "below"); }
  fs::path file(const std::string& name) const { return folder_.write(name, "x"); }
  const test::TestFolder folder_;
};

TEST_F(OutputPaths, SpareInputsUnderWhateverName) {
  const fs::path input = file("part.step"), other = file("k.csv");
  EXPECT_TRUE(spare_inputs(folder_ / "part.dxf", {input, other}));
  EXPECT_TRUE(spare_inputs(folder_ / "new.step", {input, folder_ / "absent"}));
  fs::create_symlink(other, folder_ / "link.csv");
  for (const fs::path& output :
       {input, folder_ / "below" / ".." / "part.step", folder_ / "link.csv"}) {
    const auto spared = spare_inputs(output, {folder_ / "absent", input, other});
    ASSERT_FALSE(spared) << output;
    EXPECT_EQ(spared.error().code, code::bad_option);
  }
}

TEST_F(OutputPaths, NeedAFolderThatIsThere) {
  EXPECT_TRUE(folder_exists(folder_ / "part.dxf"));
  EXPECT_TRUE(folder_exists("part.dxf")) << "the current one";
  const auto absent = folder_exists(folder_ / "no" / "part.dxf");
  ASSERT_FALSE(absent);
  EXPECT_EQ(absent.error().code, code::cannot_write);
  EXPECT_EQ(absent.error().where, (folder_ / "no" / "part.dxf").string());
  file("plain");
  EXPECT_FALSE(folder_exists(folder_ / "plain" / "part.dxf")) << "below a file";
}

TEST_F(OutputPaths, AreAllDifferent) {
  EXPECT_TRUE(all_different({folder_ / "a", folder_ / "b", "a"}));
  EXPECT_TRUE(all_different({}));
  EXPECT_EQ(all_different({folder_ / "a", folder_ / "b", folder_ / "below/../a"}).error().code,
            code::bad_option);
}

TEST_F(OutputPaths, AreNamedAfterWhatIsPacked) {
  for (const char* input : {"a/part.step", "part.STEP.GZ", "part.stp.zip", "part.zip", "part.stpZ"})
    EXPECT_EQ(stem_of_input(input), "part") << input;
  EXPECT_EQ(stem_of_input("part.v2.json"), "part.v2");
}

TEST_F(OutputPaths, LeaveOutBodiesWhoseNamesSayNothing) {
  for (const char* body :
       {"", "SOLID", "Body", "Solid1", "body-1", "COMPOUND", "Part__001",
        "Open CASCADE STEP translator 7.6 1", "MANIFOLD_SOLID_BREP #12", "FusionComponent"})
    EXPECT_TRUE(is_nameless(body)) << body;
  for (const char* body : {"Brace", "solid wall", "12", "Körper", "body of a lamp"})
    EXPECT_FALSE(is_nameless(body)) << body;
  EXPECT_TRUE(says_nothing("Brace", "sm109_Brace-V1"));
  EXPECT_TRUE(says_nothing("metal sheet_003", "Metal-Sheet-003"));
  EXPECT_TRUE(says_nothing("SOLID", "bracket"));
  EXPECT_FALSE(says_nothing("left wall", "wall"));
}

TEST_F(OutputPaths, HaveANumberForEachOfSeveralPieces) {
  EXPECT_EQ(name_of_piece("out/net.dxf", 0, 1), "out/net.dxf");
  EXPECT_EQ(name_of_piece("out/net.dxf", 0, 2), "out/net-1.dxf");
  EXPECT_EQ(name_of_piece("out/net.v2.dxf", 11, 12), "out/net.v2-12.dxf");
}

}  // namespace
}  // namespace planish::job
