#pragma once

#include <planish/base/result.hpp>
#include <planish/geometry/curve.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace planish {

/// Red, green and blue, each from 0 to 1.
using Colour = std::array<double, 3>;
inline constexpr Colour kBlack{0.0, 0.0, 0.0};

/// How lines and areas are drawn. Widths and dashes in mm.
struct Ink {
  std::optional<Colour> stroke = kBlack;
  std::optional<Colour> fill = {};
  double width = 0.25;
  std::vector<double> dashes = {};
};

enum class TextAnchor { start, middle, end };

/// How a line of text is set, upright or turned.
struct TextStyle {
  double size = 3.5;  ///< of the letters' body, mm
  bool bold = false;
  TextAnchor anchor = TextAnchor::start;
  Colour colour = kBlack;
  double turned = 0.0;  ///< counter-clockwise, rad
};

/// A page of a drawing as a value: what is drawn, in order. Coordinates are mm from the upper left
/// corner, x to the right, y down.
class Page {
 public:
  struct Shape {
    std::vector<std::vector<Vec2>> lines;
    bool closed = false;
    Ink ink;
  };
  struct Text {
    Vec2 at;  ///< on the base line
    std::string text;
    TextStyle style;
  };

  Page(double width, double height) : size_(width, height) {}

  const Vec2& size() const { return size_; }
  const std::vector<Shape>& shapes() const { return shapes_; }
  const std::vector<Text>& texts() const { return texts_; }

  void line(const Vec2& a, const Vec2& b, const Ink& ink = {}) { lines({{a, b}}, ink); }
  void lines(std::vector<std::vector<Vec2>> lines, const Ink& ink = {}) {
    shapes_.push_back({std::move(lines), false, ink});
  }
  /// An area between rings; where rings lie within one another, it alternates with what is not
  /// filled.
  void area(std::vector<std::vector<Vec2>> rings, const Ink& ink = {}) {
    shapes_.push_back({std::move(rings), true, ink});
  }
  void rectangle(const Vec2& corner, const Vec2& size, const Ink& ink = {});
  void text(const Vec2& at, std::string text, const TextStyle& style = {}) {
    texts_.push_back({at, std::move(text), style});
  }

 private:
  Vec2 size_;
  std::vector<Shape> shapes_;  ///< below the texts
  std::vector<Text> texts_;
};

/// Pages as one PDF, with embedded letters; the same pages give the same bytes. Cairo is loaded
/// when this is first called (docs/decisions/0012-cairo-is-loaded-when-pages-are-written.md).
/// Errors: `cannot_draw` if Cairo or a font is missing on this machine (the message names the
/// package), or if there are no pages.
Result<std::string> pages_pdf(const std::vector<Page>& pages, const std::string& title);

/// Pages as one SVG, below one another, in mm. Letters are text in the reader's sans-serif font.
std::string pages_svg(const std::vector<Page>& pages);

}  // namespace planish
