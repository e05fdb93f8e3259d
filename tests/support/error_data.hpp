#pragma once

#include <planish/base/result.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

// What an error says as data, beside its sentence.

namespace planish::test {

/// The first number of that name; NaN, and a failure, without one.
inline double number_in(const Error& error, std::string_view name) {
  const auto found = std::ranges::find(error.numbers, name, &NamedQuantity::name);
  if (found != error.numbers.end()) return found->quantity.value;
  ADD_FAILURE() << "no number \"" << name << "\": " << error.message;
  return std::numeric_limits<double>::quiet_NaN();
}

/// All numbers of that name.
inline std::vector<double> numbers_in(const Error& error, std::string_view name) {
  std::vector<double> values;
  for (const NamedQuantity& number : error.numbers)
    if (number.name == name) values.push_back(number.quantity.value);
  return values;
}

inline std::string unit_in(const Error& error, std::string_view name) {
  const auto found = std::ranges::find(error.numbers, name, &NamedQuantity::name);
  return found == error.numbers.end() ? "no number" : std::string(found->quantity.unit);
}

/// Ids of the places of a kind, as sentences have them.
inline std::vector<std::string> ids_in(const Error& error, PlaceKind kind) {
  std::vector<std::string> ids;
  for (const Place& place : error.places)
    if (place.kind == kind) ids.push_back(id_text(place));
  return ids;
}

/// Pointers among the places.
inline std::vector<std::string> pointers_in(const Error& error) {
  return ids_in(error, PlaceKind::pointer);
}

/// Whether its sentences are whole: no template is left open, and each ends with a full stop.
inline bool is_told(const Error& error) {
  return error.message.find('{') == std::string::npos && error.message.ends_with('.') &&
         error.message.find("..") == std::string::npos;
}

/// Where the first place of a kind lies, mm.
inline std::vector<double> at_in(const Error& error, PlaceKind kind) {
  const auto found = std::ranges::find(error.places, kind, &Place::kind);
  return found == error.places.end() ? std::vector<double>{} : found->at;
}

}  // namespace planish::test
