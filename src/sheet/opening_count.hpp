#pragma once

#include "relaid.hpp"

#include <planish/sheet/certificate.hpp>

namespace planish::sheet_detail {

/// Everything that the pattern cuts.
std::vector<Curve2> written_curves(const FlatPattern& pattern);

/// Everything that may be cut in a feature: pilot holes, holes as they will be, slits.
std::vector<const BorderLoop*> cuts_of(const FormedFeature& feature);
/// Such a cut as it lies in the pattern; the feature's face is plane.
Loop image_of_cut(const Relaid& laid, FaceId face, const BorderLoop& cut);

/// Area of the pattern's openings that are holes of formed features. They are told by where they
/// lie and how large they are.
double area_cut_in_forms(const Sheet& sheet, const FlatPattern& pattern, const Relaid& laid);

/// The openings as written, and those that should be there.
OpeningCount counted_openings(const Sheet& sheet, const FlatPattern& pattern, const Relaid& laid);

}  // namespace planish::sheet_detail
