#include "svg_shapes.hpp"

#include <planish/io/pages.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planish {
namespace {

using io_detail::svg_number;

std::string colour_text(const std::optional<Colour>& colour) {
  if (!colour) return "none";
  std::array<int, 3> bytes{};
  for (std::size_t i = 0; i < 3; ++i)
    bytes[i] = static_cast<int>(std::lround(255.0 * (*colour)[i]));
  return fmt::format("#{:02x}{:02x}{:02x}", bytes[0], bytes[1], bytes[2]);
}

std::string path_text(const Page::Shape& shape) {
  std::string data;
  for (const std::vector<Vec2>& line : shape.lines) {
    for (std::size_t i = 0; i < line.size(); ++i)
      data += fmt::format("{}{} {}", i == 0 ? "M" : "L", svg_number(line[i].x(), 3),
                          svg_number(line[i].y(), 3));
    if (shape.closed && !line.empty()) data += "Z";
  }
  return data;
}

std::string shape_text(const Page::Shape& shape) {
  std::string dashes;
  for (const double dash : shape.ink.dashes)
    dashes += (dashes.empty() ? "" : " ") + svg_number(dash, 3);
  return fmt::format("<path d=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n",
                     path_text(shape), colour_text(shape.ink.fill), colour_text(shape.ink.stroke),
                     svg_number(shape.ink.width, 3),
                     dashes.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", dashes));
}

std::string text_text(const Page::Text& text) {
  constexpr std::array kAnchors{"start", "middle", "end"};
  const double degrees = -text.style.turned * 180.0 / std::numbers::pi;
  const std::string x = svg_number(text.at.x(), 3), y = svg_number(text.at.y(), 3);
  return fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\"{}{}>{}</text>\n", x,
      y, svg_number(text.style.size, 3), kAnchors[static_cast<std::size_t>(text.style.anchor)],
      colour_text(text.style.colour), text.style.bold ? " font-weight=\"bold\"" : "",
      degrees == 0.0 ? ""
                     : fmt::format(" transform=\"rotate({} {} {})\"", svg_number(degrees), x, y),
      io_detail::xml_escaped(text.text));
}

}  // namespace

std::string pages_svg(const std::vector<Page>& pages) {
  Vec2 size = Vec2::Zero();
  for (const Page& page : pages)
    size = {std::max(size.x(), page.size().x()), size.y() + page.size().y()};
  const std::string width = svg_number(size.x(), 3), height = svg_number(size.y(), 3);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" "
      "viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" fill-rule=\"evenodd\" "
      "stroke-linejoin=\"round\" stroke-linecap=\"round\">\n",
      width, height);
  double top = 0.0;
  for (const Page& page : pages) {
    svg += fmt::format("<g transform=\"translate(0 {})\">\n", svg_number(top, 3));
    for (const Page::Shape& shape : page.shapes())
      svg += shape_text(shape);
    for (const Page::Text& text : page.texts())
      svg += text_text(text);
    svg += "</g>\n";
    top += page.size().y();
  }
  return svg + "</svg>\n";
}

}  // namespace planish
