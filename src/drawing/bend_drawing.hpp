#pragma once

#include <planish/drawing/bend_pages.hpp>
#include <planish/drawing/page_parts.hpp>

#include <span>
#include <string>
#include <vector>

namespace planish::drawing {

std::span<const Stroke> strokes_of(const BendDrawing& drawing);
/// Requires a bend of the pattern.
const FlatBend& bend_of(const BendDrawing& drawing, BendId id);
/// The lines that a stroke presses.
std::vector<Segment> pressed_lines(const BendDrawing& drawing, const Stroke& stroke);

/// As exactly as a gauge is set: to 0.1 mm, also in metres, or a thousandth of another unit.
std::string size_text(const BendDrawing& drawing, double mm);

/// The flat pattern with the numbers of its strokes and the names of its flanges, and what stands
/// in the way of bends.
void draw_flat_pattern(Page& page, const BendDrawing& drawing, const Rectangle& into);

/// Lines that are pressed without a gauge and have no dimension there, since they are neither
/// upright nor level: by stroke, from end to end, from the lower left corner of what is drawn.
std::vector<std::string> lines_to_mark(const BendDrawing& drawing);

/// "A", "B" …
std::string station_name(std::size_t number);
/// The stations of a set-up, from 0, over the width of the page, from `top` down.
void draw_bed(Page& page, const BendDrawing& drawing, int set_up, double top);
double height_of_bed(const BendDrawing& drawing, int set_up);
/// The station of a stroke; the number of stations if it has none.
std::size_t station_of(const BendDrawing& drawing, std::size_t stroke);

/// What is done in a stroke, from 0, line by line into a column, no lower than its end.
void write_stroke(Page& page, const BendDrawing& drawing, std::size_t stroke,
                  const Rectangle& into);

}  // namespace planish::drawing
