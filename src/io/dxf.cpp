#include "dxf_drawing.hpp"
#include "refusals.hpp"

#include <planish/base/assert.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/sheet/moved_pattern.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

// A flat pattern, or a sheet of nested parts, as DXF (shop-floor.md#dxf). Options and patterns are
// checked first, so a file is whole or there is none. Entities are collected before any is written,
// because extents and layers stand at the top of the file. dxflib writes the frame of each release;
// numbers are written so that they read back as the same double.

namespace planish {

using namespace io_detail;

namespace {

/// At least two periods of dash and gap, so that a short bend line visibly is dashed.
double dash_scale(const Segment& line, double unit) {
  const double periods = (line.b - line.a).norm() * unit / (kDash + kGap);
  return std::clamp(periods / 2.0, 0.01, 1.0);
}

void write(DxfWriter& writer, const DxfEntity& entity, double unit) {
  if (const auto* line = std::get_if<Segment>(&entity.geometry)) {
    const double scale = entity.style.dashed ? dash_scale(*line, unit) : 1.0;
    write_line(writer, entity.style, *line, scale);
  } else if (const auto* text = std::get_if<DxfText>(&entity.geometry)) {
    write_text(writer, entity.style, *text);
  } else {
    write_outline(writer, entity.style, std::get<Outline>(entity.geometry));
  }
}

Result<void> checked(const DxfOptions& options) {
  for (const auto& [option, value] : {std::pair{"arc_tolerance", options.arc_tolerance},
                                      std::pair{"tick_length", options.tick_length}})
    if (!std::isfinite(value) || !(value > 0.0))
      return fail(refuse::bad_dxf_option, {{"option", option}, {"value", value, unit::mm}});
  return {};
}

Result<void> checked(const FlatPattern& pattern) {
  if (auto sound = check(pattern); !sound) return sound;
  if (pattern.outer.loop.empty()) return fail(refuse::no_outer_contour);
  return {};
}

Result<std::string> written(const Drawing& drawing, const DxfOptions& options) {
  if (drawing.has_empty_outline()) return fail(refuse::contour_without_extent);
  DL_Dxf dxf;
  // dxflib learns the version only on opening a file; an empty name opens none.
  const std::unique_ptr<DL_WriterA> unused(dxf.out("", dxflib_version(options.version)));
  DxfWriter writer(options.version);
  write_prolog(dxf, writer, {drawing.extents(), options.units, drawing.layers()});
  for (const DxfEntity& entity : drawing.entities())
    write(writer, entity, millimetres_in(options.units));
  write_epilog(dxf, writer);
  return writer.text();
}

}  // namespace

Result<std::string> dxf_text(const FlatPattern& pattern, const DxfOptions& options) {
  if (auto good = checked(options); !good) return pass_on(good);
  if (auto good = checked(pattern); !good) return pass_on(good);
  Drawing drawing(options);
  drawing.add(options.turn_to_blank ? transformed(pattern, laid_by_blank(pattern)) : pattern);
  return written(drawing, options);
}

Result<std::string> sheet_dxf_text(const SheetDrawing& sheet, const DxfOptions& options) {
  if (auto good = checked(options); !good) return pass_on(good);
  if (!(std::min(sheet.length, sheet.width) > 0.0 && std::isfinite(sheet.length + sheet.width)))
    return fail(refuse::bad_sheet_size,
                {{"length", sheet.length, unit::mm}, {"width", sheet.width, unit::mm}});
  Drawing drawing(options);
  drawing.add_sheet(sheet.length, sheet.width);
  std::vector<FlatPattern> patterns;
  for (const PlacedPattern& part : sheet.parts) {
    PLANISH_ASSERT(part.flat);
    if (auto good = checked(*part.flat); !good) return pass_on(good);
    patterns.push_back(transformed(*part.flat, part.placement));
  }
  for (std::size_t i = 0; i < patterns.size(); ++i)
    drawing.add_name(patterns[i], sheet.parts[i].name);
  for (const FlatPattern& pattern : patterns)
    drawing.add(pattern);
  return written(drawing, options);
}

}  // namespace planish
