#include "page.hpp"

#include "page_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace planish::batch {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostShown = 50'000;

Json number_in(const std::string& text) { return text.empty() ? Json(nullptr) : Json::parse(text); }

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
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  return text;
}

}  // namespace

void Page::add(const Row& row, std::optional<std::size_t> distinct) {
  ++all_;
  if (distinct && *distinct >= copies_.size()) copies_.resize(*distinct + 1, 0);
  if (distinct) ++copies_[*distinct];
  auto& rows = row.status == "refused" ? refused_ : row.status == "warning" ? warnings_ : ok_;
  if (rows.size() == kMostShown) return;
  rows.push_back(in_script({{"name", row.folder},
                            {"folder", "parts/" + in_address(row.folder)},
                            {"status", row.status},
                            {"reason", row.reason},
                            {"message", row.message.empty() ? row.findings : row.message},
                            {"same", distinct ? Json(*distinct) : Json(nullptr)},
                            {"quantity", number_in(row.quantity)},
                            {"material", row.material},
                            {"thickness", number_in(row.thickness)},
                            {"length", number_in(row.length)},
                            {"width", number_in(row.width)},
                            {"bends", number_in(row.bends)},
                            {"openings", number_in(row.openings)}}));
}

std::string Page::text() const {
  std::string data = fmt::format(R"({{"all":{},"copies":[{}],"parts":[)", all_,
                                 fmt::join(copies_, ","));
  std::size_t shown = 0;
  for (const auto* rows : {&refused_, &warnings_, &ok_})
    for (const std::string& row : *rows) {
      if (shown == kMostShown) break;
      data += (shown++ == 0 ? "\n" : ",\n") + row;
    }
  data += "]}";
  std::string page = kPageText;
  constexpr std::string_view kPlace = "{{data}}";
  return page.replace(page.find(kPlace), kPlace.size(), data);
}

}  // namespace planish::batch
