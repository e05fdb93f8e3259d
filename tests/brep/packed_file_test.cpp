#include "packed_file.hpp"

#include "packed_bytes.hpp"

#include <planish/brep/codes.hpp>

#include <gtest/gtest.h>

#include <string>

namespace planish::brep {
namespace {

using planish::test::gzipped, planish::test::zipped;

const std::string kText = "ISO-10303-21; " + std::string(200'000, 'x') + " END-ISO-10303-21;";

std::string code_of(const std::string& bytes) {
  const auto text = unpacked(bytes, "a.zip");
  if (text) return "read";
  EXPECT_NE(text.error().message.find("a.zip"), std::string::npos);
  return std::string(text.error().code.name);
}

TEST(PackedFile, IsKnownByItsFirstBytes) {
  EXPECT_TRUE(is_packed(gzipped(kText)));
  EXPECT_TRUE(is_packed(zipped({{"a.step", kText}})));
  for (const char* bytes : {"", "\x1f", "PK", "ISO-10303-21;", "{}"})
    EXPECT_FALSE(is_packed(bytes)) << bytes;
}

TEST(PackedFile, ComesOutOfGzipMemberByMember) {
  EXPECT_EQ(unpacked(gzipped(kText), "a"), kText);
  EXPECT_EQ(unpacked(gzipped("ISO-") + gzipped("10303-21;"), "a"), "ISO-10303-21;");
  EXPECT_EQ(unpacked(gzipped(kText) + std::string(512, '\0'), "a"), kText) << "padded by a tape";
}

TEST(PackedFile, IsTheOnlyStepFileOfAnArchive) {
  for (const bool stored : {false, true}) {
    EXPECT_EQ(unpacked(zipped({{"a.step", kText, stored}}), "a"), kText);
    EXPECT_EQ(unpacked(zipped({{"parts/", "", true},
                               {"parts/readme.txt", "Hello", stored},
                               {"parts/A.STP", kText, stored},
                               {"__MACOSX/parts/._A.STP", "x", stored}},
                              "sent by mail"),
                       "a"),
              kText);
    EXPECT_EQ(unpacked(zipped({{"part", kText, stored}}), "a"), kText) << "whatever its name";
  }
}

TEST(PackedFile, SaysWhyItCannotBeUnpacked) {
  EXPECT_EQ(code_of(zipped({{"a.step", kText}, {"b.stp", kText}})), "invalid_input");
  EXPECT_EQ(code_of(zipped({{"a.txt", kText}, {"b.txt", kText}})), "not_step");
  EXPECT_EQ(code_of(zipped({{"a.txt", "Please cut."}})), "not_step");
  EXPECT_EQ(code_of(zipped({})), "not_step");
  EXPECT_EQ(code_of(zipped({{"a.step", kText, false, true}})), "invalid_input");
  std::string damaged = zipped({{"a.step", kText, true}});
  damaged[100] ^= 1;
  EXPECT_EQ(code_of(damaged), "truncated_file") << "the checksum says so";
}

TEST(PackedFile, IsOneOfAnArchiveByItsName) {
  const std::string zip = zipped({{"a.txt", "Hello"},
                                  {"sub\\b.STP", "ISO-1", true},
                                  {"../../c.step", "ISO-2"},
                                  {"c.step", "ISO-3"}});
  EXPECT_EQ(step_names_in(zip, "a.zip"), (std::vector<std::string>{"sub/b.STP", "c.step"}));
  EXPECT_EQ(unpacked_entry(zip, "sub/b.STP", "a.zip"), "ISO-1");
  EXPECT_EQ(unpacked_entry(zip, "c.step", "a.zip"), "ISO-2") << "the first of the name";
  const auto absent = unpacked_entry(zip, "d.step", "a.zip");
  ASSERT_FALSE(absent);
  EXPECT_EQ(absent.error().code, code::cannot_read);
}

TEST(PackedFile, CutShortAnywhereIsNoCrash) {
  const std::string zip = zipped({{"a.step", "ISO-10303-21;"}}), gzip = gzipped("ISO-10303-21;");
  for (std::size_t n = 4; n < zip.size(); ++n)
    EXPECT_EQ(code_of(zip.substr(0, n)), "truncated_file") << n;
  for (std::size_t n = 3; n < gzip.size(); ++n)
    EXPECT_EQ(code_of(gzip.substr(0, n)), "truncated_file") << n;
  for (std::size_t n = 4; n < zip.size(); ++n)
    for (const char c : {'\0', '\xff'}) {
      std::string other = zip;
      other[n] = c;
      code_of(other);
    }
}

}  // namespace
}  // namespace planish::brep
