#include "zip.hpp"

#include "support/test_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

// Read by another program: Python's zipfile.

namespace planish::pack {
namespace {

/// What Python prints of an archive; `archive` is its zipfile.
std::string python_says(const std::string& bytes, const std::string& program) {
  const test::TestFolder folder;
  folder.write("a.zip", bytes);
  folder.write("read.py",
               "import zipfile, sys\narchive = zipfile.ZipFile(sys.argv[1])\n" + program);
  const std::string command = std::string(PLANISH_PYTHON) + " " + (folder / "read.py").string() +
                              " " + (folder / "a.zip").string() + " > " +
                              (folder / "said").string();
  EXPECT_EQ(std::system(command.c_str()), 0);
  return folder.read("said");
}

std::string archive_of(const std::vector<std::pair<std::string, std::string>>& files) {
  Zip zip;
  for (const auto& [name, bytes] : files)
    EXPECT_TRUE(zip.add(name, bytes));
  return std::move(zip).take();
}

TEST(Zip, IsReadByAnotherProgram) {
  std::string bytes;
  for (int i = 0; i < 100'000; ++i)
    bytes += static_cast<char>(i * 7 % 251);
  const std::string archive = archive_of(
      {{"a.txt", "hello"}, {"Träger/ü.dxf", bytes}, {"empty", ""}});
  EXPECT_EQ(python_says(archive,
                        "print(archive.testzip())\n"
                        "print(archive.namelist())\n"
                        "print(archive.read('a.txt'))\n"
                        "print(archive.read('empty'))\n"
                        "print(archive.read('Träger/ü.dxf') == "
                        "bytes(i * 7 % 251 for i in range(100000)))\n"
                        "print({i.date_time for i in archive.infolist()})\n"),
            "None\n['a.txt', 'Träger/ü.dxf', 'empty']\nb'hello'\nb''\nTrue\n"
            "{(1980, 1, 1, 0, 0, 0)}\n");
}

TEST(Zip, IsTheSameBytesForTheSameFiles) {
  const std::vector<std::pair<std::string, std::string>> files{{"a", "1"}, {"b", "2"}};
  EXPECT_EQ(archive_of(files), archive_of(files));
  EXPECT_NE(archive_of(files), archive_of({{"b", "2"}, {"a", "1"}}));
}

TEST(Zip, PacksWhatRepeats) {
  const std::string repeated(1'000'000, 'x');
  EXPECT_LT(archive_of({{"a", repeated}}).size(), 10'000u);
}

TEST(Zip, MayBeEmpty) {
  EXPECT_EQ(python_says(archive_of({}), "print(archive.namelist())\n"), "[]\n");
}

TEST(Zip, HoldsNoMoreFilesThanItsFormat) {
  Zip zip;
  for (int i = 0; i < 65'535; ++i)
    ASSERT_TRUE(zip.add(std::to_string(i), ""));
  const auto more = zip.add("x", "");
  ASSERT_FALSE(more);
  EXPECT_EQ(more.error().code, code::cannot_write);
}

}  // namespace
}  // namespace planish::pack
