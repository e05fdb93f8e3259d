#include "batch/batch_folder.hpp"

#include <planish/batch/codes.hpp>
#include <planish/batch/inputs.hpp>

#include <gtest/gtest.h>

namespace planish::batch {
namespace {

class Inputs : public test::BatchFolder {
 protected:
  /// Names of the inputs, each with a blank behind; or the code of the error.
  std::string names_of(const std::vector<std::string>& words) const {
    const auto inputs = inputs_of(words, folder_.string() + "-out", job::built_in());
    if (!inputs) return std::string(code_name(inputs.error().code));
    std::string names;
    for (const Input& input : *inputs)
      names += input.name + " ";
    return names;
  }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
};

TEST_F(Inputs, AreAllInAFolderThatAMakerReads) {
  for (const char* name : {"b.step", "a/c.STP", "a/B.step", "x.txt", "step", ".hidden.step",
                           ".git/d.step", "a/.e/f.step"})
    write(name, "x");
  write("plates.json", R"({"plates": []})");
  write("other.json", R"({"name": 1})");
  write("broken.JSON", "{");
  EXPECT_EQ(names_of({folder_.string()}), "a/B.step a/c.STP b.step plates.json ");
  EXPECT_EQ(names_of({at("a")}), "B.step c.STP ");
}

TEST_F(Inputs, AreFilesWhateverTheyAreCalled) {
  write("odd", "x");
  EXPECT_EQ(names_of({at("odd")}), "odd ");
  EXPECT_EQ(names_of({at("odd"), at("./odd")}), "odd ") << "each once";
  EXPECT_EQ(names_of({at("absent")}), "cannot_read");
}

TEST_F(Inputs, AreWhatListsName) {
  write("sub/b.step", "x");
  write("a.step", "x");
  write("lists/more.txt", "../a.step\n");
  write("parts.txt", "# ours\n\nsub/b.step \r\n@lists/more.txt\n");
  EXPECT_EQ(names_of({"@" + at("parts.txt")}), "a.step sub/b.step ");
  write("wrong.txt", "a.step\nno.step\n");
  const auto wrong = inputs_of({"@" + at("wrong.txt")}, "/tmp/none", job::built_in());
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().message.find("2"), std::string::npos) << "the line";
  EXPECT_EQ(wrong.error().where, at("no.step"));
  write("itself.txt", "@itself.txt\n");
  EXPECT_EQ(names_of({"@" + at("itself.txt")}), "cannot_read");
  write("twice.txt", "@lists/more.txt\n@lists/more.txt\n");
  EXPECT_EQ(names_of({"@" + at("twice.txt")}), "a.step ") << "one after the other is fine";
}

TEST_F(Inputs, HaveNamesOfTheirOwn) {
  write("a/p.step", "x");
  write("b/p.step", "x");
  EXPECT_EQ(names_of({at("a/p.step"), at("b/p.step")}), "bad_option");
  EXPECT_EQ(names_of({folder_.string()}), "a/p.step b/p.step ");
}

TEST_F(Inputs, AreNotWhereResultsGo) {
  write("a/p.step", "x");
  const auto into = [&](const std::filesystem::path& out) {
    const auto inputs = inputs_of({folder_.string()}, out, job::built_in());
    return inputs ? "" : inputs.error().where;
  };
  EXPECT_EQ(into(folder_ / "out"), "output");
  EXPECT_EQ(into(folder_), "output");
  EXPECT_EQ(into(folder_.string() + "2"), "") << "beside it";
}

TEST_F(Inputs, MustBeSome) {
  write("x.txt", "x");
  EXPECT_EQ(names_of({folder_.string()}), "no_input");
  EXPECT_EQ(names_of({}), "no_input");
}

}  // namespace
}  // namespace planish::batch
