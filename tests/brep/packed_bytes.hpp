#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>
#include <vector>

/// Packed files as other programs write them, made here a second time.
namespace planish::test {

inline std::string deflated(const std::string& text, int window) {
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

inline std::string gzipped(const std::string& text) { return deflated(text, MAX_WBITS + 16); }

inline std::string number(std::size_t value, int bytes) {
  std::string text;
  for (; bytes > 0; --bytes, value >>= 8)
    text += static_cast<char>(value & 0xff);
  return text;
}

struct ZipEntry {
  std::string name, text;
  bool stored = false, encrypted = false;
};

/// APPNOTE.TXT 6.3.3: local headers, central directory, end.
inline std::string zipped(const std::vector<ZipEntry>& entries, const std::string& comment = "") {
  std::string bytes, directory;
  for (const ZipEntry& entry : entries) {
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

}  // namespace planish::test
