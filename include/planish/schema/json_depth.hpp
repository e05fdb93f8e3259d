#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace planish::schema {

/// Whoever walks through a document calls itself once a level, so that a document may be nested
/// this deep and no deeper. Files of ours need fewer than ten levels.
inline constexpr int kDeepestJson = 100;

/// The byte of the bracket that opens one level more, from 1; empty where none does. Of text that
/// is no JSON too.
std::optional<std::size_t> too_deep_at(const std::string& json);

/// Line and column of a byte, all from 1: "3:14".
std::string line_and_column(const std::string& text, std::size_t byte);

/// What is said of such a document: "is nested more than 100 deep at line:column 1:203: ...".
std::string too_deep_sentence(const std::string& json, std::size_t byte);

}  // namespace planish::schema
