#include "page_text.hpp"
#include "rows.hpp"

#include <nlohmann/json.hpp>

#include <cstdlib>

namespace planish::batch {
namespace {

using Json = nlohmann::ordered_json;

Json number(const std::string& text) { return text.empty() ? Json(nullptr) : Json::parse(text); }

/// A path as it stands in an address.
std::string in_address(const std::string& path) {
  constexpr std::string_view kPlain = "-_.~/";
  constexpr char kHex[] = "0123456789ABCDEF";
  std::string address;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || kPlain.find(c) != std::string_view::npos)
      address += c;
    else
      address += {'%', kHex[byte >> 4U], kHex[byte & 15U]};
  }
  return address;
}

}  // namespace

std::string page_of(const std::vector<Row>& rows) {
  Json data = Json::array();
  for (const Row& row : rows)
    data.push_back({{"name", row.folder},
                    {"folder", "parts/" + in_address(row.folder)},
                    {"status", row.status},
                    {"reason", row.reason},
                    {"message", row.message},
                    {"quantity", number(row.quantity)},
                    {"thickness", number(row.thickness)},
                    {"length", number(row.length)},
                    {"width", number(row.width)},
                    {"bends", number(row.bends)},
                    {"openings", number(row.openings)}});
  std::string text = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  // Nothing in it may end the script element.
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  std::string page = kPageText;
  constexpr std::string_view kPlace = "{{data}}";
  return page.replace(page.find(kPlace), kPlace.size(), text);
}

}  // namespace planish::batch
