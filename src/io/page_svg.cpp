#include <planish/io/page.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace planish {
namespace {

constexpr double kBetweenPages = 5.0;  // mm between pages

std::string hex(const Colour& colour) {
  const auto part = [&](int i) { return static_cast<int>(std::lround(255.0 * colour[i])); };
  return fmt::format("#{:02x}{:02x}{:02x}", part(0), part(1), part(2));
}

std::string in_xml(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else
      safe += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return safe;
}

std::string element(const PagePath& path, double height) {
  std::string points;
  for (const Vec2& p : path.points)
    points += fmt::format("{:.3f},{:.3f} ", p.x(), height - p.y());
  return fmt::format("<{} points=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{:.3f}\"{}/>\n",
                     path.filled ? "polygon" : "polyline", points,
                     path.filled ? hex(path.fill) : "none",
                     path.width > 0.0 ? hex(path.colour) : "none", path.width,
                     path.dash > 0.0 ? fmt::format(" stroke-dasharray=\"{:.3f}\"", path.dash) : "");
}

std::string element(const PageText& text, double height) {
  const char* anchor = text.anchor == TextAnchor::middle ? "middle"
                       : text.anchor == TextAnchor::end  ? "end"
                                                         : "start";
  return fmt::format(
      "<text x=\"{:.3f}\" y=\"{:.3f}\" font-size=\"{:.3f}\" text-anchor=\"{}\" fill=\"{}\"{}>{}"
      "</text>\n",
      text.at.x(), height - text.at.y(), text.size, anchor, hex(text.colour),
      text.bold ? " font-weight=\"bold\"" : "", in_xml(text.text));
}

}  // namespace

std::string svg_text(const std::vector<Page>& pages) {
  double width = 0.0, height = 0.0;
  std::string content;
  for (const Page& page : pages) {
    content += fmt::format(
        "<g transform=\"translate(0 {:.3f})\">\n<rect width=\"{:.3f}\" "
        "height=\"{:.3f}\" fill=\"#ffffff\"/>\n",
        height, page.width, page.height);
    for (const auto& item : page.items)
      content += std::visit([&](const auto& one) { return element(one, page.height); }, item);
    content += "</g>\n";
    width = std::max(width, page.width);
    height += page.height + kBetweenPages;
  }
  height = std::max(0.0, height - kBetweenPages);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.3f}mm\" height=\"{1:.3f}mm\" "
      "viewBox=\"0 0 {0:.3f} {1:.3f}\" font-family=\"Helvetica, Arial, sans-serif\">\n{2}</svg>\n",
      width, height, content);
}

}  // namespace planish
