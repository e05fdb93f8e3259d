#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace planish::fuzz {

/// Damages texts: bytes, numbers, references between entities, lines, spans, and pieces of other
/// files. The same seed gives the same damage on every machine.
class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : draw_(seed) {}

  /// `text` with one to three kinds of damage; `other` lends pieces.
  std::string damaged(std::string text, const std::string& other);

  /// Less than `count`, which is at least 1.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(draw_() % count); }

 private:
  struct Span {
    std::size_t at, length;
  };
  Span span_in(const std::string& text, std::size_t longest);
  /// Runs of the characters in `set`, at most a thousand from a place on.
  std::vector<Span> runs(const std::string& text, const char* set);

  void flip_bytes(std::string& text);
  void replace_number(std::string& text);
  void replace_reference(std::string& text);
  void delete_line(std::string& text);
  void cut_off(std::string& text);
  void repeat_span(std::string& text);
  void delete_span(std::string& text);
  void insert_token(std::string& text);
  void replace_word(std::string& text, const std::string& other);
  void splice(std::string& text, const std::string& other);

  std::mt19937_64 draw_;
};

}  // namespace planish::fuzz
