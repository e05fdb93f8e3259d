#pragma once

#include <planish/sheet/sheet.hpp>

#include <optional>

namespace planish {

/// Builds a sheet item by item; every maker uses it. Faces, flanges, bends and features are
/// numbered in the order in which they are added. Until `build` they can be changed through the
/// subscripts.
///
/// The rules of `check` that concern a single item (a face's part exists, a joint's borders exist)
/// are asserted when it is added.
class SheetBuilder {
 public:
  /// The reference surface is a skin, or `reference_depth` below it, mm.
  explicit SheetBuilder(double thickness, double reference_depth = 0.0);

  /// A flange or bend, as yet without faces; a bend that gets none is a sharp one.
  FlangeId add_flange();
  BendId add_bend(Bend bend = {});
  /// Adds a face to the flange or bend `face.part_of`, which then lists it.
  FaceId add_face(Face face);
  /// Joins two borders that are one edge, run in opposite directions; `sharp` is a bend without
  /// faces.
  /// `mitre_volume`: what a sharply folded corner holds beyond a bend's arc, mm³.
  void join(const BorderRef& a, const BorderRef& b, std::optional<BendId> sharp = {},
            double mitre_volume = 0.0);
  /// Adds a feature; mark the borders beyond which it lies with its id.
  FeatureId add_feature(FormedFeature feature);
  void add_opening(const MeasuredOpening& opening);
  void add_outline(const MeasuredOutline& outline);
  void add_label(PointLabel label);

  Face& operator[](FaceId id) { return sheet_.faces[id]; }
  Bend& operator[](BendId id) { return sheet_.bends[id]; }
  Border& operator[](const BorderRef& ref) { return sheet_[ref]; }
  /// The sheet so far.
  const Sheet& sheet() const { return sheet_; }

  /// Numbers the borders as edges of their own, from 1 in the order of faces, loops and borders;
  /// the two borders of a joint get the number of its first. For sheets that do not come from a
  /// solid.
  void number_edges();

  /// Measures of the whole sheet, see `Sheet`.
  void set_thickness_spread(double spread) { sheet_.thickness_spread = spread; }
  void set_volume(std::optional<double> volume) { sheet_.volume = volume; }
  void set_genus(std::optional<int> genus) { sheet_.genus = genus; }
  void set_pressed_volume(double volume) { sheet_.pressed_volume = volume; }
  /// What another feature adds to the plain sheet, mm³; empty if it cannot be measured.
  void add_form_volume(std::optional<double> volume);

  /// The finished sheet; call once. Error: that of `check`.
  Result<Sheet> build() &&;

 private:
  Sheet sheet_;
};

}  // namespace planish
