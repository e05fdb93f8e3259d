#include "zip.hpp"

#include "refusals.hpp"

#include <zlib.h>

#include <cstdint>
#include <limits>

// A ZIP archive in memory (APPNOTE.TXT 6.3.3): local headers with the deflated files, the central
// directory, its end. Times are the first that the format knows, so the same files give the same
// bytes. There is no ZIP64: more than 4 GiB or 65,535 files are refused.

namespace planish::pack {
namespace {

// APPNOTE.TXT 6.3.3, PKWARE: local file header, central directory, end of central directory.
constexpr std::uint32_t kLocal = 0x04034b50, kCentral = 0x02014b50, kEnd = 0x06054b50;
constexpr std::uint16_t kVersion = 20;     // deflate
constexpr std::uint16_t kUtf8 = 1u << 11;  // names
constexpr std::uint16_t kDeflated = 8;
constexpr std::uint16_t kMidnight = 0, kFirstDay = (1u << 5) + 1;  // 1980-01-01
constexpr std::uint64_t kLargest = std::numeric_limits<std::uint32_t>::max();
constexpr unsigned kMostFiles = std::numeric_limits<std::uint16_t>::max();

void put16(std::string& to, std::uint32_t value) {
  to += static_cast<char>(value & 0xff);
  to += static_cast<char>(value >> 8 & 0xff);
}

void put32(std::string& to, std::uint64_t value) {
  put16(to, static_cast<std::uint32_t>(value & 0xffff));
  put16(to, static_cast<std::uint32_t>(value >> 16 & 0xffff));
}

/// Raw deflate; empty if zlib fails.
std::string deflated(std::string_view bytes) {
  z_stream stream{};
  constexpr int kRaw = -MAX_WBITS, kMemory = 8;
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kRaw, kMemory, Z_DEFAULT_STRATEGY) !=
      Z_OK)
    return {};
  std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const bool whole = deflate(&stream, Z_FINISH) == Z_STREAM_END;
  packed.resize(whole ? stream.total_out : 0);
  deflateEnd(&stream);
  return packed;
}

tl::unexpected<Error> too_large() { return fail(refuse::zip_too_large); }

}  // namespace

Result<void> Zip::add(std::string_view name, std::string_view bytes) {
  if (count_ == kMostFiles || bytes.size() > kLargest) return too_large();
  const std::string packed = deflated(bytes);
  if (packed.empty()) return fail(refuse::not_deflated);
  std::string common;  // of both headers
  put16(common, kVersion);
  put16(common, kUtf8);
  put16(common, kDeflated);
  put16(common, kMidnight);
  put16(common, kFirstDay);
  put32(common,
        crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
  put32(common, packed.size());
  put32(common, bytes.size());
  put16(common, static_cast<std::uint32_t>(name.size()));
  put16(common, 0);  // extra field
  const std::uint64_t at = bytes_.size();
  put32(bytes_, kLocal);
  bytes_ += common;
  bytes_ += name;
  bytes_ += packed;
  put32(directory_, kCentral);
  put16(directory_, kVersion);
  directory_ += common;
  put16(directory_, 0);  // comment
  put16(directory_, 0);  // disk
  put16(directory_, 0);  // internal attributes
  put32(directory_, 0);  // external attributes
  put32(directory_, at);
  directory_ += name;
  ++count_;
  if (bytes_.size() + directory_.size() > kLargest) return too_large();
  return {};
}

std::string Zip::take() && {
  const std::uint64_t at = bytes_.size();
  bytes_ += directory_;
  put32(bytes_, kEnd);
  put16(bytes_, 0);  // disk
  put16(bytes_, 0);
  put16(bytes_, count_);
  put16(bytes_, count_);
  put32(bytes_, directory_.size());
  put32(bytes_, at);
  put16(bytes_, 0);  // comment
  return std::move(bytes_);
}

}  // namespace planish::pack
