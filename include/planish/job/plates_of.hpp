#pragma once

#include <planish/connect/plates.hpp>
#include <planish/sheet/sheet.hpp>

#include <string>

namespace planish::job {

struct PlatesOfOptions {
  double chord = 0.01;      ///< largest distance of the polygons from curved borders, mm
  bool with_bends = false;  ///< also which plates the bends join, and their inside radii
};

/// The flanges of a sheet as flat plates on its middle surface, as they stand in space: what
/// `connect` joins. Flange i becomes the plate "i + 1", if it has several faces "i + 1a", "i + 1b"
/// and so on. At a sharp bend they go up to the line where they meet, at others up to the bend.
/// Requires a valid sheet.
PlateStructure plates_of(const Sheet& sheet, const PlatesOfOptions& options = {});

/// A plates file (formats.md#plates), in mm, coordinates to 1e-6 mm.
std::string plates_text(const PlateStructure& plates);

}  // namespace planish::job
