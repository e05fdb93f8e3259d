#pragma once

#include <planish/base/result.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace planish::schema {

/// Whoever walks through a document calls itself once a level, so that a document may be nested
/// this deep and no deeper. Files of ours need fewer than ten levels.
inline constexpr int kDeepestJson = 100;

/// The byte of the bracket that opens one level more, from 1; empty where none does. Of text that
/// is no JSON too.
std::optional<std::size_t> too_deep_at(const std::string& json);

/// Line and column of a byte, all from 1: "3:14".
std::string line_and_column(const std::string& text, std::size_t byte);

/// What is wrong with such a document. `what` begins the sentence: "The plates file", or the name
/// of a file; `where` is that of the error, or name:line:column with `name:` alone.
Error too_deep(const std::string& json, std::size_t byte, std::string_view what, std::string where);

/// The same of text that is not JSON, from this byte on.
Error not_json(const std::string& text, std::size_t byte, std::string_view what, std::string where);

}  // namespace planish::schema
