#include "page_latin.hpp"

#include <planish/io/page.hpp>

#include <fmt/format.h>

#include <iterator>

namespace planish {
namespace {

constexpr double kPoint = 72.0 / 25.4;  // per mm

/// Objects of a PDF file, numbered from 1 in the order in which they are added.
class PdfFile {
 public:
  int add(const std::string& object) {
    starts_.push_back(text_.size());
    text_ += fmt::format("{} 0 obj\n{}\nendobj\n", starts_.size(), object);
    return static_cast<int>(starts_.size());
  }

  int add_stream(const std::string& content) {
    return add(fmt::format("<< /Length {} >>\nstream\n{}\nendstream", content.size(), content));
  }

  int next() const { return static_cast<int>(starts_.size()) + 1; }

  std::string finished(int root) const {
    std::string text = text_;
    const std::size_t table = text.size();
    text += fmt::format("xref\n0 {}\n0000000000 65535 f \n", starts_.size() + 1);
    for (const std::size_t start : starts_)
      text += fmt::format("{:010} 00000 n \n", start);
    text += fmt::format("trailer\n<< /Size {} /Root {} 0 R >>\nstartxref\n{}\n%%EOF\n",
                        starts_.size() + 1, root, table);
    return text;
  }

 private:
  std::string text_ = "%PDF-1.4\n%\xE2\xE3\xCF\xD3\n";
  std::vector<std::size_t> starts_;
};

std::string placed(const Vec2& p) {
  return fmt::format("{:.3f} {:.3f}", p.x() * kPoint, p.y() * kPoint);
}

std::string coloured(const Colour& colour, const char* with) {
  return fmt::format("{:.3f} {:.3f} {:.3f} {}\n", colour[0], colour[1], colour[2], with);
}

std::string drawn(const PagePath& path) {
  if (path.points.size() < 2) return {};
  std::string content = coloured(path.colour, "RG");
  if (path.filled) content += coloured(path.fill, "rg");
  content += fmt::format("{:.3f} w [{}] 0 d\n", path.width * kPoint,
                         path.dash > 0.0 ? fmt::format("{:.3f}", path.dash * kPoint) : "");
  for (std::size_t i = 0; i < path.points.size(); ++i)
    content += placed(path.points[i]) + (i == 0 ? " m\n" : " l\n");
  const bool line = path.width > 0.0;
  return content + (path.filled ? (line ? "b\n" : "f\n") : (line ? "S\n" : "n\n"));
}

std::string escaped(const std::string& latin) {
  std::string text;
  for (const char c : latin) {
    if (c == '(' || c == ')' || c == '\\') text += '\\';
    text += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return text;
}

std::string drawn(const PageText& text) {
  const double width = text_width(text.text, text.size, text.bold);
  const double back = text.anchor == TextAnchor::middle ? 0.5 * width
                      : text.anchor == TextAnchor::end  ? width
                                                        : 0.0;
  return coloured(text.colour, "rg") + fmt::format("BT /{} {:.3f} Tf {} Td ({}) Tj ET\n",
                                                   text.bold ? "F2" : "F1", text.size * kPoint,
                                                   placed(text.at - Vec2(back, 0.0)),
                                                   escaped(io_detail::latin_text(text.text)));
}

std::string content_of(const Page& page) {
  std::string content = "1 J 1 j\n";
  for (const auto& item : page.items)
    content += std::visit([](const auto& one) { return drawn(one); }, item);
  return content;
}

std::string font(const char* name) {
  return fmt::format("<< /Type /Font /Subtype /Type1 /BaseFont /{} /Encoding /WinAnsiEncoding >>",
                     name);
}

}  // namespace

std::string pdf_text(const std::vector<Page>& pages) {
  PdfFile file;
  const int regular = file.add(font("Helvetica")), bold = file.add(font("Helvetica-Bold"));
  const int tree = file.next() + 2 * static_cast<int>(pages.size());
  std::string kids;
  for (const Page& page : pages) {
    const int content = file.add_stream(content_of(page));
    const int number = file.add(fmt::format(
        "<< /Type /Page /Parent {} 0 R /MediaBox [0 0 {:.3f} {:.3f}] /Contents {} 0 R /Resources "
        "<< /Font << /F1 {} 0 R /F2 {} 0 R >> >> >>",
        tree, page.width * kPoint, page.height * kPoint, content, regular, bold));
    kids += fmt::format("{} 0 R ", number);
  }
  file.add(fmt::format("<< /Type /Pages /Kids [{}] /Count {} >>", kids, pages.size()));
  return file.finished(file.add(fmt::format("<< /Type /Catalog /Pages {} 0 R >>", tree)));
}

}  // namespace planish
