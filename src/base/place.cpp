#include <planish/base/message.hpp>
#include <planish/base/place.hpp>
#include <planish/base/text.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace planish {
namespace {

constexpr std::array<std::string_view, 12> kKinds{"face",   "edge",  "body",    "flange",
                                                  "bend",   "plate", "strip",   "ridge",
                                                  "stroke", "point", "pointer", "line"};

/// Files count strips and ridges from 0, people from 1.
bool counts_from_zero(PlaceKind kind) {
  return kind == PlaceKind::strip || kind == PlaceKind::ridge;
}

std::string coordinates_text(const std::vector<double>& at) {
  constexpr int kDigits = 6;
  constexpr double kRounding = 1e-6;  // mm: far below anything drawn, and told as 0
  std::string text = "(";
  for (const double x : at) {
    if (text.size() > 1) text += ", ";
    text += number_text(std::abs(x) < kRounding ? 0.0 : x, kDigits);
  }
  return text + ")";
}

std::string pointer_text(const std::string& pointer) {
  constexpr std::size_t kShown = 200;  // bytes
  return pointer.empty() ? "the whole input" : shortened(pointer, kShown);
}

}  // namespace

std::string_view kind_name(PlaceKind kind) { return *(kKinds.begin() + static_cast<int>(kind)); }

std::string id_text(const Place& place) {
  if (const int* number = std::get_if<int>(&place.id))
    return std::to_string(counts_from_zero(place.kind) ? *number + 1 : *number);
  const std::string* name = std::get_if<std::string>(&place.id);
  if (!name) return coordinates_text(place.at);
  if (place.kind == PlaceKind::pointer) return pointer_text(*name);
  return place.kind == PlaceKind::plate ? fmt::format("\"{}\"", *name) : *name;
}

std::string escaped_token(std::string_view key) {
  return replaced(key, {{'~', "~0"}, {'/', "~1"}});
}

std::string text_of(const Place& place) {
  if (place.kind == PlaceKind::pointer || std::holds_alternative<std::monostate>(place.id))
    return id_text(place);
  std::string text = fmt::format("{} {}", kind_name(place.kind), id_text(place));
  if (place.faces.size() == 2)
    text += fmt::format(" between face {} and face {}", place.faces[0], place.faces[1]);
  return text;
}

}  // namespace planish
