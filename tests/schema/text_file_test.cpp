#include <planish/schema/text_file.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

namespace planish::schema {
namespace {

std::filesystem::path scratch_file(const std::string& name) {
  return std::filesystem::path(::testing::TempDir()) / ("planish_text_file_" + name);
}

TEST(TextFile, IsReadToTheLastByte) {
  const auto file = scratch_file("bytes");
  constexpr std::size_t kBlock = 1 << 16;
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, kBlock, 2 * kBlock + 3}) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i)
      bytes += static_cast<char>(i * 31 + i / 256);
    std::ofstream(file, std::ios::binary) << bytes;
    const auto read = read_text(file, "plates file");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_TRUE(*read == bytes) << size;
  }
  std::filesystem::remove(file);
}

TEST(TextFile, OfOneDashIsStandardInput) {
  std::istringstream given("a\nb");
  std::streambuf* const before = std::cin.rdbuf(given.rdbuf());
  const auto read = read_text("-", "plates file");
  std::cin.rdbuf(before);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, "a\nb");
}

TEST(TextFile, ThatCannotBeReadIsNamedWithItsKind) {
  const auto absent = scratch_file("absent");
  const auto folder = std::filesystem::path(::testing::TempDir());
  for (const std::filesystem::path& file : {absent, folder}) {
    const auto read = read_text(file, "plates file");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, code::cannot_read);
    EXPECT_EQ(read.error().where, file.string());
    EXPECT_THAT(read.error().message, ::testing::HasSubstr("plates file"));
  }
}

}  // namespace
}  // namespace planish::schema
