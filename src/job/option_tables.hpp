#pragma once

#include <planish/job/options.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace planish::job {

// The tables of which `options()` is made, each in a file of its name.
const std::vector<Option>& sheet_options();    ///< how the sheet is made and laid flat
const std::vector<Option>& dxf_options();      ///< how a DXF is written
const std::vector<Option>& shop_options();     ///< the shop profile: in check_options.cpp
const std::vector<Option>& check_options();    ///< what the shop asks of a pattern
const std::vector<Option>& bending_options();  ///< what is done at the press brake

/// Stores a value in the member of a request that a path of members leads to.
template <auto... path>
Result<void> stored(Request& to, const OptionValue& value) {
  auto& member = (to.*....*path);
  using Member = std::remove_reference_t<decltype(member)>;
  if constexpr (std::is_same_v<Member, int>)
    member = static_cast<int>(std::get<double>(value));
  else if constexpr (std::is_same_v<Member, std::optional<double>>)
    member = std::get<double>(value);
  else
    member = std::get<Member>(value);
  return {};
}

/// Rows that are about one thing.
struct OptionRows {
  OptionGroup group;
  std::vector<Option> rows;
};
std::vector<Option> joined(std::vector<OptionRows> groups);

/// A row by its kind. `said`: the description; `set` stores the value; `otherwise`: the default in
/// words.
namespace row {

using Text = std::string_view;
using Set = Result<void> (*)(Request& request, const OptionValue& value);

inline Option flag(Text name, Text said, Set set) {
  return {.name = name, .kind = OptionKind::flag, .description = said, .set = set};
}
inline Option name(Text name, Text said, Set set, Text otherwise = {}) {
  return {.name = name,
          .kind = OptionKind::name,
          .description = said,
          .otherwise = otherwise,
          .set = set};
}
inline Option number(Text name, schema::Range range, Text said, Set set, Text otherwise = {}) {
  return {.name = name,
          .kind = OptionKind::number,
          .description = said,
          .otherwise = otherwise,
          .range = range,
          .set = set};
}
inline Option word(Text name, std::vector<Text> words, Text otherwise, Text said, Set set,
                   OptionKind kind = OptionKind::word) {
  return {.name = name,
          .kind = kind,
          .description = said,
          .otherwise = otherwise,
          .words = std::move(words),
          .set = set};
}
inline Option file(Text name, Text type, Text kind, Text said, Set set) {
  return {.name = name,
          .kind = OptionKind::file,
          .description = said,
          .file_type = type,
          .file_kind = kind,
          .set = set};
}

}  // namespace row

inline const std::string& given_text(const OptionValue& value) {
  return std::get<std::string>(value);
}
inline const OptionFile& file_of(const OptionValue& value) { return std::get<OptionFile>(value); }
inline bool yes(const OptionValue& value) { return std::get<bool>(value); }

}  // namespace planish::job
