#pragma once

#include <planish/brake/stroke_search.hpp>

#include <bit>
#include <cstddef>

namespace planish::brake_detail {

inline LineSet no_lines(int lines) { return LineSet((static_cast<std::size_t>(lines) + 63) / 64); }

inline bool holds(const LineSet& set, int line) { return (set[line / 64] >> (line % 64) & 1) != 0; }

inline void insert(LineSet& set, int line) { set[line / 64] |= std::uint64_t{1} << (line % 64); }

inline LineSet all_lines(int lines) {
  LineSet set = no_lines(lines);
  for (int line = 0; line < lines; ++line)
    insert(set, line);
  return set;
}

inline LineSet joined(LineSet a, const LineSet& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] |= b[i];
  return a;
}

inline LineSet common(LineSet a, const LineSet& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] &= b[i];
  return a;
}

inline LineSet without(LineSet a, const LineSet& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] &= ~b[i];
  return a;
}
inline bool disjoint(const LineSet& a, const LineSet& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if ((a[i] & b[i]) != 0) return false;
  return true;
}

inline bool within(const LineSet& part, const LineSet& whole) {
  for (std::size_t i = 0; i < part.size(); ++i)
    if ((part[i] & ~whole[i]) != 0) return false;
  return true;
}

inline int count(const LineSet& set) {
  int lines = 0;
  for (const std::uint64_t word : set)
    lines += std::popcount(word);
  return lines;
}

inline std::vector<int> members(const LineSet& set) {
  std::vector<int> lines;
  for (std::size_t i = 0; i < set.size(); ++i)
    for (std::uint64_t word = set[i]; word != 0; word &= word - 1)
      lines.push_back(static_cast<int>(64 * i) + std::countr_zero(word));
  return lines;
}

/// The first line of a set that is not empty.
inline int first_line(const LineSet& set) {
  std::size_t word = 0;
  while (set[word] == 0)
    ++word;
  return static_cast<int>(64 * word) + std::countr_zero(set[word]);
}

/// A set with one line.
inline LineSet only(int lines, int line) {
  LineSet set = no_lines(lines);
  insert(set, line);
  return set;
}

struct LineSetHash {
  std::size_t operator()(const LineSet& set) const {
    std::uint64_t hash = 0x9E3779B97F4A7C15u;  // the golden ratio, as splitmix64 has it
    for (const std::uint64_t word : set) {
      hash = (hash ^ word) * 0xBF58476D1CE4E5B9u;
      hash ^= hash >> 31;
    }
    return hash;
  }
};

}  // namespace planish::brake_detail
