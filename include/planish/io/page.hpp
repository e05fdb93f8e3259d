#pragma once

#include <planish/geometry/frame.hpp>

#include <array>
#include <string>
#include <variant>
#include <vector>

namespace planish {

/// Shares of red, green and blue, 0 to 1.
using Colour = std::array<double, 3>;
inline constexpr Colour kBlack{0.0, 0.0, 0.0};

/// A chain of straight lines on a page, mm.
struct PagePath {
  std::vector<Vec2> points;
  Colour colour = kBlack;
  double width = 0.25;  ///< of the line; 0: not drawn
  bool filled = false;  ///< closed, and filled with `fill`
  Colour fill = {};
  double dash = 0.0;  ///< length of dashes and gaps; 0: solid
};

enum class TextAnchor { start, middle, end };

/// A line of text; `at` is on its base line.
struct PageText {
  Vec2 at;
  std::string text;
  double size = 3.0;  ///< mm, height of a line
  TextAnchor anchor = TextAnchor::start;
  bool bold = false;
  Colour colour = kBlack;
};

/// A sheet of paper, mm; the origin is its lower left corner, y up.
struct Page {
  double width = 210.0, height = 297.0;
  std::vector<std::variant<PagePath, PageText>> items;
};

/// Width of a text in Helvetica, mm; characters outside Latin-1 count as "?".
double text_width(const std::string& text, double size, bool bold);

/// PDF 1.4 in the fonts that every viewer has: what is outside Latin-1 is written as "?". The same
/// pages give the same bytes.
std::string pdf_text(const std::vector<Page>& pages);

/// The pages one below the other.
std::string svg_text(const std::vector<Page>& pages);

}  // namespace planish
