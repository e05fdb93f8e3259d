#pragma once

#include <planish/base/result.hpp>

#include <cairo-pdf.h>

// The functions of Cairo that pages use, without "cairo_".
#define PLANISH_CAIRO_FUNCTIONS(use)                                                             \
  use(pdf_surface_create_for_stream) use(pdf_surface_set_metadata) use(pdf_surface_set_size)     \
      use(surface_destroy) use(surface_finish) use(surface_status) use(status_to_string)         \
          use(create) use(destroy) use(status) use(show_page) use(save) use(restore)             \
              use(translate) use(rotate) use(new_path) use(move_to) use(line_to) use(close_path) \
                  use(set_source_rgb) use(set_fill_rule) use(set_line_width) use(set_line_cap)   \
                      use(set_line_join) use(set_dash) use(fill_preserve) use(stroke_preserve)   \
                          use(select_font_face) use(set_font_size) use(text_extents)             \
                              use(show_text) use(scale)

namespace planish::io_detail {

/// Cairo, loaded by hand: linked, it and the twenty libraries behind it would take 2 ms of every
/// run (docs/decisions/0012-cairo-is-loaded-when-pages-are-written.md).
struct Cairo {
#define PLANISH_CAIRO_MEMBER(name) decltype(&cairo_##name) name = nullptr;
  PLANISH_CAIRO_FUNCTIONS(PLANISH_CAIRO_MEMBER)
#undef PLANISH_CAIRO_MEMBER
};

/// Loaded once. Error: `cannot_draw`, with the package that is missing.
Result<const Cairo*> cairo();

}  // namespace planish::io_detail
