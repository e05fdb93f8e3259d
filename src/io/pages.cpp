#include "cairo_library.hpp"
#include "refusals.hpp"

#include <planish/io/pages.hpp>

#include <memory>

// Pages as PDF by Cairo, which is loaded when the first is drawn
// (decisions/0012-cairo-is-loaded-when-pages-are-written.md). All sizes are mm; only the context's
// scale knows points. Cairo leaves text out without an error where there is no font, so the width
// of a letter is asked for first. The file holds no time, and the same pages give the same bytes.

namespace planish {
namespace {

using io_detail::Cairo;

constexpr double kPoint = 25.4 / 72.0;  // mm
constexpr const char* kFamily = "sans-serif";

cairo_status_t append(void* text, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/// Draws on a page of the surface that it holds, in mm.
class Pen {
 public:
  Pen(const Cairo& cairo, cairo_surface_t* surface)
      : cairo_(cairo), context_(cairo.create(surface), cairo.destroy) {
    cairo_.scale(at(), 1.0 / kPoint, 1.0 / kPoint);
    cairo_.set_fill_rule(at(), CAIRO_FILL_RULE_EVEN_ODD);
    cairo_.set_line_join(at(), CAIRO_LINE_JOIN_ROUND);
    cairo_.set_line_cap(at(), CAIRO_LINE_CAP_ROUND);
  }

  void draw(const Page& page) {
    for (const Page::Shape& shape : page.shapes())
      draw(shape);
    for (const Page::Text& text : page.texts())
      draw(text);
    cairo_.show_page(at());
  }

  /// Whether there are letters to set: without a font, text is left out without an error.
  bool has_letters() {
    set_font({});
    cairo_text_extents_t extents;
    cairo_.text_extents(at(), "M", &extents);
    return extents.width > 0.0;
  }

  cairo_status_t status() const { return cairo_.status(context_.get()); }

 private:
  cairo_t* at() { return context_.get(); }

  void set_colour(const Colour& colour) {
    cairo_.set_source_rgb(at(), colour[0], colour[1], colour[2]);
  }

  void draw(const Page::Shape& shape) {
    cairo_.new_path(at());
    for (const std::vector<Vec2>& line : shape.lines) {
      for (std::size_t i = 0; i < line.size(); ++i)
        (i == 0 ? cairo_.move_to : cairo_.line_to)(at(), line[i].x(), line[i].y());
      if (shape.closed && !line.empty()) cairo_.close_path(at());
    }
    if (shape.ink.fill) {
      set_colour(*shape.ink.fill);
      cairo_.fill_preserve(at());
    }
    if (!shape.ink.stroke) return;
    set_colour(*shape.ink.stroke);
    cairo_.set_line_width(at(), shape.ink.width);
    const std::vector<double>& dashes = shape.ink.dashes;
    cairo_.set_dash(at(), dashes.data(), static_cast<int>(dashes.size()), 0.0);
    cairo_.stroke_preserve(at());
  }

  void set_font(const TextStyle& style) {
    cairo_.select_font_face(at(), kFamily, CAIRO_FONT_SLANT_NORMAL,
                            style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_.set_font_size(at(), style.size);
  }

  void draw(const Page::Text& text) {
    set_font(text.style);
    set_colour(text.style.colour);
    cairo_text_extents_t extents;
    cairo_.text_extents(at(), text.text.c_str(), &extents);
    const double share = text.style.anchor == TextAnchor::start    ? 0.0
                         : text.style.anchor == TextAnchor::middle ? 0.5
                                                                   : 1.0;
    cairo_.save(at());
    cairo_.translate(at(), text.at.x(), text.at.y());
    cairo_.rotate(at(), -text.style.turned);
    cairo_.move_to(at(), -share * extents.x_advance, 0.0);
    cairo_.show_text(at(), text.text.c_str());
    cairo_.restore(at());
  }

  const Cairo& cairo_;
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context_;
};

}  // namespace

void Page::rectangle(const Vec2& corner, const Vec2& size, const Ink& ink) {
  area({{corner,
         {corner.x() + size.x(), corner.y()},
         corner + size,
         {corner.x(), corner.y() + size.y()}}},
       ink);
}

Result<std::string> pages_pdf(const std::vector<Page>& pages, const std::string& title) {
  if (pages.empty()) return fail(refuse::nothing_to_draw);
  const auto loaded = io_detail::cairo();
  if (!loaded) return pass_on(loaded);
  const Cairo& cairo = **loaded;
  std::string text;
  const auto points = [](const Vec2& size) -> Vec2 { return size / kPoint; };
  const Vec2 first = points(pages.front().size());
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo.pdf_surface_create_for_stream(append, &text, first.x(), first.y()),
      cairo.surface_destroy);
  cairo.pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, title.c_str());
  // Without this the time of day would be in the file.
  cairo.pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
  cairo_status_t status = CAIRO_STATUS_SUCCESS;
  for (const Page& page : pages) {
    const Vec2 size = points(page.size());
    cairo.pdf_surface_set_size(surface.get(), size.x(), size.y());
    Pen pen(cairo, surface.get());
    if (!pen.has_letters()) return fail(refuse::no_font);
    pen.draw(page);
    if (status == CAIRO_STATUS_SUCCESS) status = pen.status();
  }
  cairo.surface_finish(surface.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo.surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS)
    return fail(refuse::cairo_failed, {{"reason", cairo.status_to_string(status)}});
  return text;
}

}  // namespace planish
