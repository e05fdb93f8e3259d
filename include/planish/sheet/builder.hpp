#pragma once

#include <planish/sheet/sheet.hpp>

#include <optional>

namespace planish {

/// Builds a sheet row by row; every maker makes its sheet so. Rows are numbered in the order in
/// which they are added. Until `build` the rows can be changed through the subscripts.
///
/// The rules of `check` that concern one row alone (a face's part is there, a joint's borders are)
/// are held when the row is added, by assertions.
class SheetBuilder {
 public:
  /// The reference surface is a skin, or `reference_depth` below it, mm.
  explicit SheetBuilder(double thickness, double reference_depth = 0.0);

  /// A flange or bend without faces yet; a bend that stays without is a sharp one.
  FlangeId add_flange();
  BendId add_bend(Bend bend = {});
  /// A face of the flange or bend that `face.part_of` names, which then lists it.
  FaceId add_face(Face face);
  /// Two borders that are one edge, run in opposite directions; `sharp` names a bend without faces.
  void join(const BorderRef& a, const BorderRef& b, std::optional<BendId> sharp = {});
  /// The feature; mark the borders beyond which it lies with the id.
  FeatureId add_feature(FormedFeature feature);
  void add_label(PointLabel label);

  Face& operator[](FaceId id) { return sheet_.faces[id]; }
  Bend& operator[](BendId id) { return sheet_.bends[id]; }
  Border& operator[](const BorderRef& ref) { return sheet_[ref]; }
  /// What there is of the sheet so far.
  const Sheet& sheet() const { return sheet_; }

  /// Numbers the borders as edges of their own, from 1 in the order of faces, loops and borders;
  /// the two borders of a joint get the number of its first. For sheets that come from no solid.
  void number_edges();

  /// Sizes that belong to the whole, see `Sheet`.
  void set_thickness_spread(double spread) { sheet_.thickness_spread = spread; }
  void set_volume(std::optional<double> volume) { sheet_.volume = volume; }
  void set_genus(std::optional<int> genus) { sheet_.genus = genus; }
  /// What one more feature adds to the plain sheet; none: it cannot be measured.
  void add_form_volume(std::optional<double> volume);
  void add_mitre_volume(double volume) { sheet_.mitres_volume += volume; }

  /// The sheet; a builder makes one. Error: that of `check`.
  Result<Sheet> build() &&;

 private:
  Sheet sheet_;
};

}  // namespace planish
