#include "packed_file.hpp"

#include "brep_text.hpp"
#include "refusals.hpp"
#include "step_header.hpp"

#include <planish/brep/step_archive.hpp>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

// STEP files as they are sent: gzip (RFC 1952, members one after the other), and ZIP (APPNOTE.TXT
// 6.3.3) by its central directory, which alone has the sizes of all entries. Whatever a directory
// says is checked against the bytes that are there; what comes out is bounded, and its checksum
// compared.

namespace planish::brep {
namespace {

constexpr std::string_view kGzip = "\x1f\x8b\x08", kZip = "PK\x03\x04";
constexpr std::size_t kMost = std::size_t{1} << 31;  // bytes

// APPNOTE.TXT 6.3.3: central directory and its end.
constexpr std::uint32_t kEntry = 0x02014b50, kEnd = 0x06054b50;
constexpr std::size_t kEntrySize = 46, kEndSize = 22, kLocalSize = 30, kLongestComment = 0xffff;
constexpr unsigned kStored = 0, kDeflated = 8;
constexpr int kGzipWindow = MAX_WBITS + 16;

std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint32_t number = 0;
  for (std::size_t i = size; i-- > 0;)
    number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

/// What zlib makes of bytes; `window` chooses their format. `used` says how many of them belong to
/// it.
class Inflating {
 public:
  Inflating(std::string_view bytes, int window) {
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    left_ = bytes.size();
    ready_ = inflateInit2(&stream_, window) == Z_OK;
  }
  Inflating(const Inflating&) = delete;
  Inflating& operator=(const Inflating&) = delete;
  ~Inflating() {
    if (ready_) inflateEnd(&stream_);
  }

  enum class End { whole, damaged, too_large };

  /// Adds what comes out to a text.
  End into(std::string& text) {
    constexpr std::size_t kAtOnce = std::size_t{1} << 16;
    if (!ready_) return End::damaged;
    std::array<char, kAtOnce> out;
    for (int state = Z_OK; state != Z_STREAM_END;) {
      if (stream_.avail_in == 0) refill();
      stream_.next_out = reinterpret_cast<Bytef*>(out.data());
      stream_.avail_out = static_cast<uInt>(out.size());
      state = inflate(&stream_, Z_NO_FLUSH);
      if (state != Z_OK && state != Z_STREAM_END) return End::damaged;
      text.append(out.data(), out.size() - stream_.avail_out);
      if (text.size() > kMost) return End::too_large;
    }
    return End::whole;
  }

  /// Bytes that follow.
  std::size_t left() const { return left_ + stream_.avail_in; }

 private:
  void refill() {
    const std::size_t some = std::min<std::size_t>(left_, std::size_t{1} << 30);
    stream_.avail_in = static_cast<uInt>(some);
    left_ -= some;
  }

  z_stream stream_{};
  std::size_t left_ = 0;
  bool ready_ = false;
};

std::optional<Error> complaint(Inflating::End end, const std::string& name) {
  if (end == Inflating::End::too_large)
    return error_of(refuse::unpacks_too_large, {{"file", name}, {"most", kMost >> 20, "MiB"}},
                    name);
  if (end == Inflating::End::damaged)
    return error_of(refuse::damaged_archive, {{"file", name}}, name);
  return std::nullopt;
}

Result<std::string> gunzipped(std::string_view bytes, const std::string& name) {
  std::string text;
  do {
    Inflating member(bytes, kGzipWindow);
    if (const auto wrong = complaint(member.into(text), name)) return tl::unexpected(*wrong);
    bytes.remove_prefix(bytes.size() - member.left());
  } while (bytes.starts_with(kGzip));
  return text;
}

struct ZipEntry {
  std::string name;
  bool encrypted = false;
  unsigned method = kStored;
  std::uint32_t checksum = 0;
  std::size_t packed = 0, size = 0, local = 0;

  bool is_folder() const { return name.ends_with('/'); }
  bool is_step() const { return has_step_name(name); }
};

/// A name in an archive as a path below it: programs of Windows write other slashes, and no name
/// may lead out of the archive.
std::string path_within(std::string name) {
  std::ranges::replace(name, '\\', '/');
  std::filesystem::path path;
  for (const auto& step : std::filesystem::path(name).lexically_normal().relative_path())
    if (step != "..") path /= step;
  return path.generic_string();
}

/// The entries of the central directory that the bytes hold, if they hold one; what a Mac adds is
/// left out.
std::optional<std::vector<ZipEntry>> entries_of(std::string_view bytes) {
  if (bytes.size() < kEndSize) return std::nullopt;
  std::size_t end = bytes.size() - kEndSize;
  const std::size_t first = end - std::min(end, kLongestComment);
  while (end > first && number_at(bytes, end, 4) != kEnd)
    --end;
  if (number_at(bytes, end, 4) != kEnd) return std::nullopt;
  std::vector<ZipEntry> entries;
  std::size_t at = number_at(bytes, end + 16, 4);
  for (auto count = number_at(bytes, end + 10, 2); count > 0; --count) {
    if (at > end || end - at < kEntrySize || number_at(bytes, at, 4) != kEntry) break;
    const std::size_t length = number_at(bytes, at + 28, 2);
    const std::size_t more = number_at(bytes, at + 30, 2) + number_at(bytes, at + 32, 2);
    if (end - at - kEntrySize < length + more) break;
    ZipEntry entry{.name = path_within(std::string(bytes.substr(at + kEntrySize, length))),
                   .encrypted = (number_at(bytes, at + 8, 2) & 1u) != 0,
                   .method = number_at(bytes, at + 10, 2),
                   .checksum = number_at(bytes, at + 16, 4),
                   .packed = number_at(bytes, at + 20, 4),
                   .size = number_at(bytes, at + 24, 4),
                   .local = number_at(bytes, at + 42, 4)};
    at += kEntrySize + length + more;
    if (!entry.is_folder() && !entry.name.empty() && !entry.name.starts_with("__MACOSX/"))
      entries.push_back(std::move(entry));
  }
  return entries;
}

Result<std::string> content_of(std::string_view bytes, const ZipEntry& entry,
                               const std::string& name) {
  const auto damaged = [&] { return fail(refuse::damaged_archive, {{"file", name}}, name); };
  if (entry.encrypted || (entry.method != kStored && entry.method != kDeflated))
    return fail(refuse::strange_archive, {{"file", name}, {"entry", entry.name}}, name);
  if (entry.local > bytes.size() || bytes.size() - entry.local < kLocalSize) return damaged();
  const std::size_t head = kLocalSize + number_at(bytes, entry.local + 26, 2) +
                           number_at(bytes, entry.local + 28, 2);
  bytes.remove_prefix(entry.local);
  if (bytes.size() < head || bytes.size() - head < entry.packed) return damaged();
  bytes = bytes.substr(head, entry.packed);
  std::string text;
  if (entry.method == kStored)
    text = bytes;
  else if (const auto wrong = complaint(Inflating(bytes, -MAX_WBITS).into(text), name))
    return tl::unexpected(*wrong);
  const auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size());
  if (text.size() != entry.size || sum != entry.checksum) return damaged();
  return text;
}

Result<std::vector<ZipEntry>> step_entries(std::string_view bytes, const std::string& name) {
  const auto all = entries_of(bytes);
  if (!all) return fail(refuse::damaged_archive, {{"file", name}}, name);
  std::vector<ZipEntry> steps = *all;
  std::erase_if(steps, [](const ZipEntry& entry) { return !entry.is_step(); });
  if (!steps.empty()) return steps;
  if (all->size() == 1) {
    const auto content = content_of(bytes, all->front(), name);
    if (!content || begins_as_shape(*content)) return *all;
  }
  return fail(refuse::archive_without_step, {{"file", name}, {"count", all->size()}}, name);
}

Result<std::string> unzipped(std::string_view bytes, const std::string& name) {
  const auto entries = step_entries(bytes, name);
  if (!entries) return pass_on(entries);
  if (entries->size() > 1)
    return fail(
        refuse::archive_of_several,
        {{"file", name}, {"count", entries->size()}, {"first", name + "/" + entries->front().name}},
        name);
  return content_of(bytes, entries->front(), name);
}

}  // namespace

bool begins_as_shape(std::string_view text) {
  return begins_as_step(text) || is_kernel_shape(text);
}

bool is_archive(std::string_view bytes) { return bytes.starts_with(kZip); }

bool is_packed(std::string_view bytes) { return bytes.starts_with(kGzip) || is_archive(bytes); }

Result<std::string> unpacked(std::string_view bytes, const std::string& name) {
  return bytes.starts_with(kGzip) ? gunzipped(bytes, name) : unzipped(bytes, name);
}

std::string unpacked_beginning(std::string_view gzip) {
  std::string text;
  static_cast<void>(Inflating(gzip, kGzipWindow).into(text));  // which ends where the bytes do
  return text;
}

Result<std::vector<std::string>> step_names_in(std::string_view archive, const std::string& name) {
  const auto entries = step_entries(archive, name);
  if (!entries) return pass_on(entries);
  std::vector<std::string> names;
  for (const ZipEntry& entry : *entries)
    if (!std::ranges::count(names, entry.name)) names.push_back(entry.name);
  return names;
}

Result<std::string> unpacked_entry(std::string_view archive, const std::string& entry,
                                   const std::string& name) {
  const auto all = entries_of(archive);
  if (!all) return fail(refuse::damaged_archive, {{"file", name}}, name);
  const auto found = std::ranges::find(*all, entry, &ZipEntry::name);
  if (found == all->end())
    return fail(refuse::not_in_archive, {{"file", name}, {"entry", entry}}, name);
  return content_of(archive, *found, name + "/" + entry);
}

}  // namespace planish::brep
