#pragma once

#include <planish/drawing/part_view.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/io/pages.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <string>
#include <utility>
#include <vector>

namespace planish::drawing {

/// What a drawing of a part shows.
struct PartDrawing {
  std::string title = {}, subtitle = {};
  std::vector<std::pair<std::string, std::string>> facts = {};  ///< name and value
  const FlatPattern* flat = nullptr;
  const PartView* view = nullptr;  ///< null: the folded part is not drawn
  std::vector<std::string> warnings = {}, notes = {};
  LengthUnit units = LengthUnit::mm;
};

/// A part on pages for the shop, A4 upright: the folded part, the facts, the flat pattern with
/// overall sizes and bend lines, the table of bends, warnings and notes. Requires a flat pattern
/// with an outer contour.
std::vector<Page> part_pages(const PartDrawing& drawing);

/// Draws a view or a pattern as large as it fits in, for lists of parts.
void draw_view(Page& page, const PartView& view, const Vec2& corner, const Vec2& size);
void draw_flat(Page& page, const FlatPattern& flat, const Vec2& corner, const Vec2& size);

}  // namespace planish::drawing
