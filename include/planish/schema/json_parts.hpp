#pragma once

#include <planish/geometry/frame.hpp>
#include <planish/schema/units.hpp>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace planish::schema {

/// Keys stay in the order in which they are written here, so equal reports are equal bytes.
using Json = nlohmann::ordered_json;

/// NaN and infinity, which JSON cannot express, become null.
Json number_json(double value);
Json number_json(const std::optional<double>& value);
Json point_json(const Vec2& p, const Units& units);
Json space_point_json(const Vec3& p, const Units& units);
/// The list of what `function` makes of each element of a range.
template <typename Range>
Json json_array(const Range& range, const auto& function) {
  Json json = Json::array();
  for (const auto& one : range)
    json.push_back(function(one));
  return json;
}
/// Text of a document, indented by two spaces, ending with a line break. Bytes that are not UTF-8
/// (in names from files) become U+FFFD.
std::string text_of(const Json& document);

}  // namespace planish::schema
