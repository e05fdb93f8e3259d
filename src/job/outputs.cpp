#include <planish/base/text.hpp>
#include <planish/brep/step.hpp>
#include <planish/job/outputs.hpp>
#include <planish/schema/units.hpp>
#include <planish/schema/utf8.hpp>

#include <fmt/format.h>

#include <array>
#include <set>

// Names of files from names of bodies, which may be anything. Letters of all scripts and digits
// stay, all else becomes underscores, so no name leaves its folder. Some file systems know no case,
// so names are kept apart without it, by numbers that are tried until one is free.

namespace planish::job {
using namespace schema;
namespace {

constexpr std::size_t kLongestName = 100;  // bytes; with thickness and suffix far below any limit

struct Block {
  char32_t first, last;
};

// Letters of other scripts, by blocks: outside them are punctuation, symbols, marks that change the
// writing direction, private use and the like.
constexpr std::array kLetters{Block{0xC0, 0xD6},      Block{0xD8, 0xF6},     Block{0xF8, 0x1FFF},
                              Block{0x2C00, 0x2DFF},  Block{0x3041, 0xD7FF}, Block{0xF900, 0xFDFF},
                              Block{0x20000, 0x323AF}};

bool is_ascii_letter_or_digit(char32_t c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

bool stays(char32_t c) {
  if (c < 0x80) return is_ascii_letter_or_digit(c) || c == '-' || c == '_' || c == '.';
  for (const Block& block : kLetters) {
    if (c >= block.first && c <= block.last) return true;
  }
  return false;
}

}  // namespace

std::string safe_name(const std::string& name) {
  std::string safe;
  for (const CodePoint& c : code_points(name)) {
    const bool keep = c.valid && stays(c.value);
    const std::string_view next = keep ? c.bytes : "_";
    if (!keep && !safe.empty() && safe.back() == '_') continue;
    if (safe.size() + next.size() > kLongestName) break;
    safe += next;
  }
  safe.erase(0, safe.find_first_not_of(".-"));
  safe.erase(safe.find_last_not_of("._") + 1);
  return safe.empty() ? "body" : safe;
}

std::vector<std::string> stems(const std::vector<Outcome<UnfoldReport>>& bodies) {
  std::vector<std::string> all;
  std::set<std::string> taken;
  for (const Outcome<UnfoldReport>& body : bodies) {
    all.emplace_back();
    if (!body) continue;
    const std::string wanted = fmt::format("{}_t{}", safe_name(body->body),
                                           trimmed_number(body->summary.thickness, 3));
    std::string stem = wanted;
    // "a-2" may itself be a body's name.
    for (int n = 2; !taken.insert(lower_case(stem)).second; ++n) {
      stem = fmt::format("{}-{}", wanted, n);
    }
    all.back() = stem;
  }
  return all;
}

}  // namespace planish::job
