#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/geometry/mesh.hpp>
#include <planish/sheet/certificate.hpp>
#include <planish/sheet/flat_pattern.hpp>
#include <planish/sheet/rip.hpp>
#include <planish/sheet/sheet.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace planish {

/// One solid body of a file. Cheap to copy; the kernel's shape stays behind the wall.
class Body {
 public:
  struct Shape;
  explicit Body(std::shared_ptr<const Shape> shape);
  const Shape& shape() const { return *shape_; }
  const std::string& name() const;  ///< STEP product name, or "body-<n>"
  int quantity() const;             ///< number of identical bodies in the file (not mirrored)
  int face_count() const;
  const std::string& material() const;    ///< as the file spells it; empty: it does not say
  std::optional<double> density() const;  ///< kg/dm³, as the file says
  const std::string& colour() const;      ///< "#rrggbb"; empty: it has none, or several
  double volume() const;                  ///< mm³
  Vec3 size() const;                      ///< extents along x, y, z, mm

 private:
  std::shared_ptr<const Shape> shape_;
};

/// What a STEP file holds. Lengths are mm whatever the file's unit was.
struct StepFile {
  std::string schema;                   ///< e.g. "AP214 (AUTOMOTIVE_DESIGN)"
  std::string cad_system;               ///< originating system as stated in the header
  std::string unit;                     ///< length unit of the file, "mm", "inch", …
  std::vector<Body> bodies;             ///< distinct bodies in file order
  int surface_bodies = 0;               ///< shells that are not part of a solid
  std::shared_ptr<const void> content;  ///< what the kernel made of the text. Nothing needs it;
                                        ///< it is here because freeing it takes a while: reset it
                                        ///< to save memory, keep it to save time
};

/// Reads a STEP file (AP203, AP214, AP242), or a shape in the kernel's own form (.brep, text or
/// binary; lengths are mm), also packed: by gzip, alone in a ZIP archive, or as the path names it
/// there ("parts.zip/left.step"). Identical bodies are merged (`quantity`); mirror images are not
/// identical. Errors: `cannot_read`, `empty_file`, `not_step`, `truncated_file`, `invalid_input`,
/// `shell_not_solid`, `no_solid`, `cancelled`.
Result<StepFile> read_step(const std::filesystem::path& file, const Progress& progress = {});
/// The same from memory; `name` is used in messages.
Result<StepFile> read_step_text(const std::string& text, const std::string& name,
                                const Progress& progress = {});

struct RecognizeOptions {
  double surface_tolerance = 0.01;  ///< mm: a spline surface this near a plane, cylinder, … counts
                                    ///< as one
  double thickness_tolerance = 0.02;  ///< of the thickness: spread allowed between skins
  std::vector<int> rip_edges = {};    ///< along which the sheet is cut open (sheet/rip.hpp)
  /// Only a sheet of this thickness (mm) is looked for, though it may be as narrow as a bar, or up
  /// to half of it milled off.
  std::optional<double> thickness = {};
  /// What a closed sheet must pass, besides, for a refusal to name the rips that open it.
  SheetCheck passes = {};
};

/// A recognised sheet with the distances that `certify` needs.
struct Recognized {
  Sheet sheet;
  EdgeDistance distance;
  std::vector<std::string> notes;  ///< observations, one sentence each
};

/// Finds the sheet in a solid: thickness, two skins, flanges, bends, features. Errors:
/// `not_a_sheet`, `thickness_not_constant`, `doubly_curved`, `closed_loop` (it names a rip if rips
/// open the sheet), `unsupported_shape`.
Result<Recognized> recognize(const Body& body, const RecognizeOptions& options = {});

/// Flat solid of the sheet's thickness as STEP text (AP214, mm): the pattern extruded over z = −t …
/// 0.
Result<std::string> flat_solid_step(const FlatPattern& pattern, const std::string& name);

/// Folded solid of a sheet with its real thickness. Errors: those of `folded_solid_step`.
Result<Body> folded_body(const Sheet& sheet, const std::string& name);
/// A body as STEP text (AP214, mm), under its name. Error: `internal` (the kernel fails).
Result<std::string> step_text(const Body& body);

/// The text of the folded body: planes, cylinders and cones stay
/// analytic.
Result<std::string> folded_solid_step(const Sheet& sheet, const std::string& name);

/// The sheet's reference surface as STEP text (AP214, mm): an open shell whose faces are oriented
/// as in the sheet. Planes, cylinders and cones stay analytic; faces share the edge of a joint,
/// smooth or sharp, so nothing is sewn. Joined borders more than 1e-3 mm apart (strips that do not
/// reach each other) are left free, so that the gap shows; unconnected parts are separate shells.
/// Errors: `invalid_input` (joints that do not fit, no faces), `unsupported_shape` (a bend surface
/// of radius zero), `internal` (the kernel finds the result invalid).
Result<std::string> folded_surface_step(const Sheet& sheet, const std::string& name);

/// The solids bounded by a closed mesh as STEP text (AP214, mm): one for each connected part.
/// Triangles in one plane become one face. Errors: `invalid_input` (a triangle without area, corner
/// indices out of range, edges not shared by two triangles in opposite directions, a part whose
/// volume is not positive), `internal` (the kernel fails).
Result<std::string> mesh_solid_step(const Mesh& mesh, const std::string& name);

/// The folded solid as a closed mesh: every triangle edge is shared with one neighbour, which runs
/// it the other way. Corner points lie on the solid, triangles within `chord` mm of it, and along
/// curved borders neighbouring chords turn by at most 10°, so that small radii look round. Points
/// and triangles come in the order of the sheet's faces. Cost: proportional to the number of
/// triangles, for cylindrical bends about 1/√chord. Errors: `bad_option` (chord not positive),
/// those of `folded_solid_step` for a sheet that has no solid, `internal` (the kernel's mesh has a
/// gap).
Result<Mesh> folded_mesh(const Sheet& sheet, double chord = 0.05);

/// Mesh of a body as read, by face, numbered as in `info` but from 0. Like `folded_mesh`: faces
/// share their points along an edge, the mesh is closed, and its volume is the body's but for a
/// layer as thick as the chord. Where the kernel fails otherwise, neighbouring chords turn by up to
/// 25°. Errors: `bad_option` (chord not positive), `internal` (the kernel's mesh is none of this).
Result<MeshOfFaces> body_mesh(const Body& body, double chord = 0.05);

/// The same, to be looked at: faces that the kernel does not mesh rightly are left out. Errors:
/// `bad_option` (chord not positive), `internal` (no triangles).
Result<MeshOfFaces> body_mesh_in_part(const Body& body, double chord);

/// The same triangles where every face has its own points.
/// Errors: `bad_option` (chord not positive), `internal` (the kernel's triangles do not close).
Result<MeshOfFaces> body_faces_mesh(const Body& body, double chord);

}  // namespace planish
