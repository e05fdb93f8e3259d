#include "batch/batch_folder.hpp"

#include <planish/batch/codes.hpp>
#include <planish/batch/inputs.hpp>

#include <gtest/gtest.h>
#include <sys/fsuid.h>
#include <unistd.h>

#include <map>

namespace planish::batch {
namespace {

class Inputs : public test::BatchFolder {
 protected:
  /// Names of the inputs, each with a blank behind; or the code of the error.
  std::string names_of(const std::vector<std::string>& words) const {
    const auto inputs = inputs_of(words, folder_.string() + "-out", job::built_in());
    if (!inputs) return std::string(code_name(inputs.error().code));
    std::string names;
    for (const Input& input : inputs->files)
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

TEST_F(Inputs, AreWantedAsOftenAsAListSays) {
  for (const char* name : {"a.step", "b.step", "c.step", "sub/d.step", "odd x3"})
    write(name, "x");
  write("sub/more.txt", "d.step x2\n");
  write("parts.txt", "a.step x20\nb.step\t×4\nc.step\n@sub/more.txt X3\nodd x3\n");
  const auto inputs = inputs_of({"@" + at("parts.txt")}, "/tmp/none", job::built_in());
  ASSERT_TRUE(inputs) << inputs.error().message;
  std::map<std::string, int> copies;
  for (const Input& input : inputs->files)
    copies[input.name] = input.copies;
  EXPECT_EQ(copies,
            (std::map<std::string, int>{
                {"a.step", 20}, {"b.step", 4}, {"c.step", 1}, {"d.step", 6}, {"odd x3", 1}}));
  EXPECT_EQ(inputs->files[0].said_by, at("parts.txt") + ", line 1");
  for (const char* wrong : {"a.step x0", "a.step x2.5", "a.step x1000001"}) {
    write("wrong.txt", std::string("c.step\n") + wrong + "\n");
    const auto refused = inputs_of({"@" + at("wrong.txt")}, "/tmp/none", job::built_in());
    ASSERT_FALSE(refused) << wrong;
    EXPECT_EQ(refused.error().code, code::invalid_input) << wrong;
    EXPECT_NE(refused.error().message.find("wrong.txt, line 2"), std::string::npos) << wrong;
  }
}

TEST_F(Inputs, HaveNamesWithBlanksInLists) {
  for (const char* name : {"left x4.step", "right x5.step", "no 3 # x.step", "quoted one.step"})
    write(name, "x");
  write("parts.txt",
        "\xEF\xBB\xBFleft x4.step\r\n  right x5.step\tx3 # of steel\r\n"
        "no 3 # x.step x2\r\n\"quoted one.step\" ×7\r\n");
  const auto inputs = inputs_of({"@" + at("parts.txt")}, "/tmp/none", job::built_in());
  ASSERT_TRUE(inputs) << inputs.error().message;
  std::map<std::string, int> copies;
  for (const Input& input : inputs->files)
    copies[input.name] = input.copies;
  EXPECT_EQ(copies, (std::map<std::string, int>{{"left x4.step", 1},
                                                {"right x5.step", 3},
                                                {"no 3 # x.step", 2},
                                                {"quoted one.step", 7}}));
  write("absent.txt", "left x6.step\n");
  const auto absent = inputs_of({"@" + at("absent.txt")}, "/tmp/none", job::built_in());
  ASSERT_FALSE(absent);
  EXPECT_EQ(absent.error().code, code::cannot_read) << "a name, not a quantity";
  EXPECT_EQ(absent.error().where, at("left x6.step"));
}

TEST_F(Inputs, AreListedInAnyText) {
  for (const char* name : {"a.step", "b.step"})
    write(name, "x");
  write("mac.txt", "a.step\rb.step x2\r");
  EXPECT_EQ(names_of({"@" + at("mac.txt")}), "a.step b.step ");
  write("wide.txt", std::string("\xFF\xFE"
                                "a\0.\0s\0",
                                8));
  EXPECT_EQ(names_of({"@" + at("wide.txt")}), "invalid_input") << "UTF-16";
}

TEST_F(Inputs, AreNotCountedTwice) {
  write("a.step", "x");
  write("twice.txt", "a.step x2\na.step x3\n");
  EXPECT_EQ(names_of({"@" + at("twice.txt")}), "invalid_input");
  write("twice.txt", "a.step x2\na.step\n");
  EXPECT_EQ(names_of({"@" + at("twice.txt")}), "invalid_input");
  write("twice.txt", "a.step\na.step\n");
  EXPECT_EQ(names_of({"@" + at("twice.txt")}), "a.step ");
}

TEST_F(Inputs, ToldWhatTheyAreNot) {
  for (const char* name : {"a.step", "sub/b.igs", "drawing.pdf", ".hidden"})
    write(name, "x");
  write("other.json", R"({"name": 1})");
  std::filesystem::create_symlink("nothing.step", folder_ / "gone.step");
  std::filesystem::create_directory_symlink("sub", folder_ / "link");
  const auto inputs = inputs_of({folder_.string()}, "/tmp/none", job::built_in());
  ASSERT_TRUE(inputs);
  EXPECT_EQ(inputs->files.size(), 1u);
  EXPECT_EQ(inputs->passed_over.count, 5u);
  std::string names;
  for (const PassedFile& file : inputs->passed_over.files) {
    names += file.name + " ";
    EXPECT_EQ(file.reason, "no_input");
    EXPECT_FALSE(file.why.empty());
  }
  EXPECT_EQ(names, "drawing.pdf gone.step link other.json sub/b.igs ");
}

/// Works as nobody, who may not read what is root's; for this thread alone.
class AsNobody {
 public:
  AsNobody() { setfsuid(kNobody); }
  ~AsNobody() { setfsuid(geteuid()); }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;

 private:
  static constexpr uid_t kNobody = 65534;
};

TEST_F(Inputs, LoseOnlyAFolderThatCannotBeRead) {
  write("a.step", "x");
  write("locked/b.step", "x");
  write("open/c.step", "x");
  std::filesystem::permissions(folder_ / "locked", std::filesystem::perms::none);
  {
    const AsNobody nobody;
    EXPECT_EQ(names_of({folder_.string()}), "a.step open/c.step ");
    const auto inputs = inputs_of({folder_.string()}, "/tmp/none", job::built_in());
    ASSERT_TRUE(inputs);
    ASSERT_EQ(inputs->passed_over.files.size(), 1u);
    EXPECT_EQ(inputs->passed_over.files[0].name, "locked");
    EXPECT_EQ(inputs->passed_over.files[0].reason, "cannot_read");
    EXPECT_EQ(names_of({at("locked")}), "cannot_read") << "nothing else is there";
  }
  std::filesystem::permissions(folder_ / "locked", std::filesystem::perms::owner_all);
}

TEST_F(Inputs, MustBeSome) {
  write("x.txt", "x");
  EXPECT_EQ(names_of({folder_.string()}), "no_input");
  EXPECT_EQ(names_of({}), "no_input");
}

}  // namespace
}  // namespace planish::batch
