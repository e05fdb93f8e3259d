#pragma once

#include "features.hpp"

namespace planish::brep {

/// Adds what a face whose loops are taken from its silhouette has beside its cut: the skins' own
/// outlines, drawn where they differ from it, the volume that is machined off, and how far the
/// solid reaches into each opening.
void add_silhouette(SheetBuilder& builder, const SheetMap& map, const Recognition& of, int face);

/// The area of what is cut along a face's silhouette, openings taken off; and what the solid has
/// beyond it, which counts as the volume of a form, mm³. Empty where that is not known.
double silhouette_area(const Sheet& sheet, const SheetMap& map, const Recognition& of, int face);
std::optional<double> volume_beyond_silhouette(const Sheet& sheet, const SheetMap& map,
                                               const Recognition& of, int face);

/// Measures how far the rim reaches beyond the outline that is cut, for each plane face beside
/// which something of it looks the skin's way.
void measure_outlines(SheetBuilder& builder, const SheetMap& map, const Recognition& of);

}  // namespace planish::brep
