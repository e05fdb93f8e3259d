#include "piece_sheet.hpp"
#include "presses.hpp"
#include "refusals.hpp"
#include "request_check.hpp"
#include "surface_mesh.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/transition/transition.hpp>

// A transition from its request to sheets: the ring of patches, seams that cut it into pieces,
// press lines, names. The net's pieces and the pieces to fold are made from the same ring; only the
// latter lose tips, where the inside radius would be too small, and are open at a single seam
// (transition.md#output). A piece that would lose a tenth of its area is refused.

namespace planish {
namespace {

using namespace transition_detail;

/// Ends of rulings that are one point of a template; a share of the extent. The hull finds places
/// to about 1e-9 of it.
constexpr double kSamePoint = 100.0 * tolerance::kComputed;

/// A piece that loses more than this share cannot be folded.
constexpr double kMostCut = 0.1;

/// No transition is a kilometre wide or long, and far larger ones lose what doubles can tell; mm.
constexpr double kLargest = 1e6;
constexpr double kMmInKm = 1e6;

/// The ring, and the parts of each piece.
struct Division {
  Ring ring;
  std::vector<std::vector<PatchPart>> pieces;
};

Result<Division> divided(const TransitionSpec& spec, const TransitionOptions& options) {
  if (!(options.tolerance > 0.0))
    return fail(refuse::bad_transition_option, {{"name", "The tolerance"},
                                                {"value", options.tolerance, unit::none},
                                                {"range", "a value above 0"}});
  if (auto sound = check_request(spec); !sound) return pass_on(sound);
  auto ring = ring_of(spec, options);
  if (!ring) return pass_on(ring);
  if (ring->size > kLargest)
    return fail(refuse::too_large, {{"size", ring->size / kMmInKm, unit::kilometres},
                                    {"most", kLargest / kMmInKm, unit::kilometres},
                                    {"field", place::pointer("/to")}});
  auto cuts = cuts_of(*ring, spec.seam, spec.pieces);
  if (!cuts) return pass_on(cuts);
  if (ring->count() == 1) {
    const double moved = cuts->front().at;
    ring = begun_at(*ring, moved, options.tolerance * ring->size);
    for (Cut& cut : *cuts)
      cut.at -= moved;
  }
  Division division{std::move(*ring), {}};
  for (std::size_t i = 0; i < cuts->size(); ++i)
    division.pieces.push_back(
        parts_between(division.ring, (*cuts)[i], (*cuts)[(i + 1) % cuts->size()]));
  if (auto pressed = check_presses(division.ring, division.pieces, spec.pressing); !pressed)
    return pass_on(pressed);
  return division;
}

TransitionPatch measured(const RuledPatch& patch) {
  return {patch.kind(),
          patch.area(0.0, 1.0),
          {patch.border_length(0, 0.0, 1.0), patch.border_length(1, 0.0, 1.0)},
          Angle::radians(patch.turn(0.0, 1.0))};
}

Result<void> add_pieces(Transition& transition, const Division& division,
                        const TransitionSpec& spec) {
  const Ring& ring = division.ring;
  RulingNames names(*ring.hull, kSamePoint * ring.size);
  for (const auto& parts : division.pieces) {
    const int piece = static_cast<int>(transition.pieces.size());
    auto sheet = named_sheet(ring, spec, parts, piece, names);
    if (!sheet) return pass_on(sheet);
    transition.pieces.push_back(std::move(*sheet));
  }
  transition.true_lengths = names.true_lengths();
  return {};
}

/// The area missing from a piece once `tips` are cut off as well.
Result<double> with_tips(double area, const Ring& ring, const std::vector<PatchPart>& parts,
                         const TipCuts& tips) {
  for (const PatchPart& part : parts) {
    const RuledPatch& patch = ring.patch(part.patch);
    if (auto room = tips.leave_room(patch, part.from, part.to); !room) return pass_on(room);
    area += patch.tip_area(part.from, part.to, tips.of(patch, part.from, part.to));
  }
  return area;
}

std::optional<std::array<Vec3, 2>> ridge_of(const Boundary& top) {
  if (top.count() != 2) return std::nullopt;
  const auto start = [&](int i) { return top.element(i).curve(top.element(i).t0).point; };
  return std::array{start(0), start(1)};
}

Result<void> check_cut(const Ring& ring, const std::vector<PatchPart>& parts, double cut,
                       const TransitionSpec& spec) {
  const double whole = sum_of(parts, [&](const PatchPart& part) {
    return ring.patch(part.patch).area(part.from, part.to);
  });
  if (cut <= kMostCut * whole) return {};
  return fail(refuse::too_much_cut, {{"thickness", spec.thickness, unit::mm},
                                     {"share", 100.0 * cut / whole, unit::percent},
                                     {"field", place::pointer("/thickness")}});
}

}  // namespace

Result<Transition> make_transition(const TransitionSpec& spec, const TransitionOptions& options,
                                   const Progress& progress) {
  if (!(options.mesh_chord > 0.0))
    return fail(refuse::bad_transition_option, {{"name", "The chord of the mesh"},
                                                {"value", options.mesh_chord, unit::mm},
                                                {"range", "a value above 0"}});
  const auto division = divided(spec, options);
  if (!division) return pass_on(division);
  if (progress.should_stop()) return fail(refuse::cancelled);
  Transition transition;
  for (const RuledPatch& ruled : division->ring.patches) {
    const TransitionPatch& patch = transition.patches.emplace_back(measured(ruled));
    transition.area += patch.area;
    for (std::size_t side = 0; side < 2; ++side)
      transition.perimeters[side] += patch.border[side];
  }
  if (auto added = add_pieces(transition, *division, spec); !added) return pass_on(added);
  transition.mesh = surface_mesh(division->ring, options.mesh_chord);
  return transition;
}

Result<std::vector<FoldedPiece>> folded_pieces(const TransitionSpec& spec,
                                               const TransitionOptions& options) {
  auto division = divided(spec, options);
  if (!division) return pass_on(division);
  const Ring& ring = division->ring;
  const double open = division->pieces.size() == 1 ? open_seam(ring, division->pieces.front())
                                                   : 0.0;
  const TipCuts tips(ring, division->pieces, spec);
  std::vector<FoldedPiece> pieces;
  for (const auto& parts : division->pieces) {
    const PatchPart &first = parts.front(), &last = parts.back();
    const auto missing = with_tips(open, ring, parts, tips);
    if (!missing) return pass_on(missing);
    if (auto enough = check_cut(ring, parts, *missing, spec); !enough) return pass_on(enough);
    auto sheet = cut_sheet(ring, spec, parts, tips);
    if (!sheet) return pass_on(sheet);
    pieces.push_back(
        {std::move(*sheet),
         *missing,
         {ring.patch(first.patch).ruling(first.from), ring.patch(last.patch).ruling(last.to)},
         ridge_of(ring.hull->boundaries[1])});
  }
  return pieces;
}

}  // namespace planish
