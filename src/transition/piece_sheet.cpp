#include "piece_sheet.hpp"

#include "presses.hpp"

#include <planish/sheet/builder.hpp>

#include <fmt/format.h>

#include <algorithm>

// A piece of the net as a Sheet: planes become flanges, curved patches bends with their press
// lines, edges between two planes sharp bends, joined in the order of the ring. Ends of the rulings
// that a template shows are named, with true lengths; a name that equals that on the ruling before
// is not repeated.

namespace planish::transition_detail {
namespace {

/// A part of a patch and the face that it becomes.
struct PartFace {
  PatchPart range;
  RuledPatch::Part part;
  std::vector<RuledPatch::Press> presses;  ///< of bends
};

PartFace face_of(const Ring& ring, const PatchPart& range, const Pressing& pressing,
                 const RuledPatch::Tips& tips) {
  const RuledPatch& patch = ring.patch(range.patch);
  PartFace face{range, patch.part(range.from, range.to, tips), {}};
  if (!patch.plane()) face.presses = presses_of(patch, range.from, range.to, pressing);
  return face;
}

Bend bend_of(const RuledPatch& patch, const PartFace& face, const TransitionSpec& spec) {
  const auto& [range, part, presses] = face;
  Bend bend;
  bend.kind = patch.bend_kind();
  bend.angle = Angle::radians(patch.turned(range.from, range.to));
  bend.inside_radius = std::max(
      0.0, patch.smallest_radii(range.from, range.to).middle - spec.k_factor * spec.thickness);
  for (const RuledPatch::Press& press : presses)
    bend.press_lines.push_back({part.u(press.at), Angle::radians(press.turn)});
  if (part.u1 < part.u0) std::ranges::reverse(bend.press_lines);
  return bend;
}

/// Joins the faces in order; face i of the sheet is that of part i.
SheetBuilder assembled(const Ring& ring, const TransitionSpec& spec,
                       const std::vector<PartFace>& faces) {
  SheetBuilder sheet(spec.thickness, (1.0 - spec.k_factor) * spec.thickness);
  std::optional<BorderRef> last;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto& [range, part, presses] = faces[i];
    const RuledPatch& patch = ring.patch(range.patch);
    std::optional<BendId> sharp;
    if (last)
      if (const double fold = fold_between(ring, faces[i - 1].range, range); fold > 0.0)
        sharp = sheet.add_bend(sharp_bend(fold));
    Face face = part.face;
    if (patch.plane())
      face.part_of = sheet.add_flange();
    else
      face.part_of = sheet.add_bend(bend_of(patch, faces[i], spec));
    const FaceId id = sheet.add_face(std::move(face));
    if (last) sheet.join(*last, {id, 0, part.ruling_borders[0]}, sharp);
    last = {id, 0, part.ruling_borders[1]};
  }
  sheet.number_edges();
  return sheet;
}

/// A ruling that a template shows, and the number of its press line.
struct ShownRuling {
  double at = 0.0;
  std::string press;
};

/// Lines of bend n are called Bn.1, Bn.2 …, with u growing.
std::vector<ShownRuling> shown_rulings(const PartFace& face, const PartId& part_of) {
  const auto& [range, part, presses] = face;
  std::vector<ShownRuling> rulings{{range.from, ""}};
  const std::size_t count = presses.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::string bend = fmt::format("B{}", index_of(std::get<BendId>(part_of)) + 1);
    const std::size_t line = part.u1 < part.u0 ? count - i : i + 1;
    rulings.push_back({presses[i].at, count == 1 ? bend : fmt::format("{}.{}", bend, line)});
  }
  rulings.push_back({range.to, ""});
  return rulings;
}

/// (u, v) of a point on the ruling `at`.
Vec2 uv_of(const RuledPatch::Part& part, double at, const Vec3& p) {
  if (const auto* plane = std::get_if<Frame>(&part.face.surface)) return plane->local2(p);
  const auto& surface = std::get<Developable>(part.face.surface);
  const double u = part.u(at);
  return {u, ruling_on(surface, u).dot(p - point_on(surface, {u, 0.0}))};
}

/// Names both ends of all rulings; a name equal to that on the previous ruling is not repeated.
void add_labels(SheetBuilder& sheet, const Ring& ring, const std::vector<PartFace>& faces,
                int piece, RulingNames& names) {
  std::array<std::string, 2> last;
  for (const FaceId id : sheet.sheet().faces.ids()) {
    const PartFace& face = faces[index_of(id)];
    for (const ShownRuling& ruling : shown_rulings(face, sheet.sheet()[id].part_of)) {
      const std::array<Vec3, 2> ends = ring.patch(face.range.patch).ruling(ruling.at);
      const std::array<std::string, 2> named = names.add(ends, ruling.press, piece);
      for (std::size_t side = 0; side < 2; ++side) {
        if (named[side] == last[side]) continue;
        last[side] = named[side];
        sheet.add_label({id, uv_of(face.part, ruling.at, ends[side]), named[side]});
      }
    }
  }
}

}  // namespace

Result<Sheet> named_sheet(const Ring& ring, const TransitionSpec& spec,
                          const std::vector<PatchPart>& parts, int piece, RulingNames& names) {
  const auto faces = mapped(
      parts, [&](const PatchPart& part) { return face_of(ring, part, spec.pressing, {}); });
  SheetBuilder sheet = assembled(ring, spec, faces);
  add_labels(sheet, ring, faces, piece, names);
  return std::move(sheet).build();
}

Result<Sheet> cut_sheet(const Ring& ring, const TransitionSpec& spec,
                        const std::vector<PatchPart>& parts, const TipCuts& cuts) {
  const auto faces = mapped(parts, [&](const PatchPart& part) {
    return face_of(ring, part, spec.pressing, cuts.of(ring.patch(part.patch), part.from, part.to));
  });
  return assembled(ring, spec, faces).build();
}

}  // namespace planish::transition_detail
