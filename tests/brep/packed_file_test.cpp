#include "packed_file.hpp"

#include <planish/brep/codes.hpp>

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>
#include <vector>

namespace planish::brep {
namespace {

std::string deflated(const std::string& text, int window) {
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, window, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string packed(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

std::string gzipped(const std::string& text) { return deflated(text, MAX_WBITS + 16); }

std::string number(std::size_t value, int bytes) {
  std::string text;
  for (; bytes > 0; --bytes, value >>= 8)
    text += static_cast<char>(value & 0xff);
  return text;
}

struct Entry {
  std::string name, text;
  bool stored = false, encrypted = false;
};

/// APPNOTE.TXT 6.3.3: local headers, central directory, end.
std::string zipped(const std::vector<Entry>& entries, const std::string& comment = "") {
  std::string bytes, directory;
  for (const Entry& entry : entries) {
    const std::string packed = entry.stored ? entry.text : deflated(entry.text, -MAX_WBITS);
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(entry.text.data()),
                           static_cast<uInt>(entry.text.size()));
    const std::string common = number(20, 2) + number(entry.encrypted, 2) +
                               number(entry.stored ? 0 : 8, 2) + number(0, 4) + number(sum, 4) +
                               number(packed.size(), 4) + number(entry.text.size(), 4) +
                               number(entry.name.size(), 2) + number(0, 2);
    directory += number(0x02014b50, 4) + number(20, 2) + common + number(0, 2) + number(0, 2) +
                 number(0, 2) + number(0, 4) + number(bytes.size(), 4) + entry.name;
    bytes += number(0x04034b50, 4) + common + entry.name + packed;
  }
  return bytes + directory + number(0x06054b50, 4) + number(0, 4) + number(entries.size(), 2) +
         number(entries.size(), 2) + number(directory.size(), 4) + number(bytes.size(), 4) +
         number(comment.size(), 2) + comment;
}

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
  EXPECT_EQ(code_of(zipped({})), "not_step");
  EXPECT_EQ(code_of(zipped({{"a.step", kText, false, true}})), "invalid_input");
  std::string damaged = zipped({{"a.step", kText, true}});
  damaged[100] ^= 1;
  EXPECT_EQ(code_of(damaged), "truncated_file") << "the checksum says so";
}

TEST(PackedFile, CutShortAnywhereIsNoCrash) {
  const std::string zip = zipped({{"a.step", "ISO-10303-21;"}}), gzip = gzipped("ISO-10303-21;");
  for (std::size_t n = 4; n < zip.size(); ++n)
    EXPECT_EQ(code_of(zip.substr(0, n)), "not_step") << n;
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
