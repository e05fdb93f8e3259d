#include "page.hpp"

#include "page_text.hpp"
#include "state.hpp"

#include <planish/base/id_vector.hpp>
#include <planish/base/text.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <string_view>

// The page of a batch: one file, in whose script each part is a row of JSON. Parts that were made
// come first. A browser shows only so many rows, so no more are kept, refused ones before all
// others; the total is said on the page. No text of a part may end the script element.

namespace planish::batch {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostShown = 50'000;

template <typename Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// Why a part was refused, or what was found, in sentences.
std::vector<std::string> messages_of(const PartRecord& part) {
  if (!part.message.empty()) return {part.message};
  return mapped(warnings_of(part), [](const auto& one) { return capitalized(one.message) + "."; });
}

/// A path as it stands in an address.
std::string in_address(const std::string& path) {
  constexpr std::string_view kPlain = "-_.~/";
  std::string address;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || kPlain.find(c) != std::string_view::npos)
      address += c;
    else
      address += fmt::format("%{:02X}", byte);
  }
  return address;
}

/// JSON that may stand in a script element: nothing in it may end the element.
std::string in_script(const Json& json) {
  return replaced(json.dump(-1, ' ', false, Json::error_handler_t::replace), {{'<', "\\u003c"}});
}

}  // namespace

void Page::add(const PartRecord& part, std::optional<std::size_t> distinct) {
  ++all_;
  if (distinct && *distinct >= copies_.size()) copies_.resize(*distinct + 1, 0);
  if (distinct) ++copies_[*distinct];
  auto& [count, rows] = part.status == "refused"   ? refused_
                        : part.status == "warning" ? warnings_
                                                   : ok_;
  ++count;
  if (rows.size() == kMostShown) return;
  rows.push_back(in_script({{"name", part.folder},
                            {"folder", "parts/" + in_address(part.folder)},
                            {"status", part.status},
                            {"reason", part.reason},
                            {"messages", messages_of(part)},
                            {"same", or_null(distinct)},
                            {"quantity", or_null(part.quantity)},
                            {"material", part.material},
                            {"thickness", or_null(part.thickness)},
                            {"length", or_null(part.length)},
                            {"width", or_null(part.width)},
                            {"bends", or_null(part.bends)},
                            {"openings", or_null(part.openings)}}));
}

std::string Page::text(const PassedOver& passed) const {
  // What is kept where there are too many: most of all what a person has to look at.
  std::size_t room = kMostShown;
  const auto kept = [&](const Rows& of) {
    const auto& rows = of.rows;
    const std::size_t count = std::min(room, rows.size());
    room -= count;
    return fmt::format(
        "{}", fmt::join(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(count), ",\n"));
  };
  const auto refused = kept(refused_), warnings = kept(warnings_), ok = kept(ok_);
  std::string parts;
  for (const auto& rows : {ok, warnings, refused}) {
    if (rows.empty()) continue;
    parts += fmt::format("{}\n{}", parts.empty() ? "" : ",", rows);
  }
  const std::string data = fmt::format(
      R"({{"all":{},"ok":{},"warnings":{},"refused":{},"copies":[{}],)"
      R"("passedOver":{},"parts":[{}]}})",
      all_, ok_.count, warnings_.count, refused_.count, fmt::join(copies_, ","),
      in_script(passed_over_json(passed)), parts);
  std::string page = kPageText;
  constexpr std::string_view kPlace = "{{data}}";
  return page.replace(page.find(kPlace), kPlace.size(), data);
}

}  // namespace planish::batch
