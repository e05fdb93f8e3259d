#include "self_intersections.hpp"

#include "sentences.hpp"

#include <planish/brep/step.hpp>
#include <planish/collision/meeting_faces.hpp>
#include <planish/collision/self_intersections.hpp>
#include <planish/sheet/material_places.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

// Where the folded sheet runs through itself (math.md#self-intersection). A look at the faces of
// the sheet saves meshing most bodies; what it suspects is measured on triangles of the solid,
// there only. Developing the centre of shared space back tells which parts meet; each pair is one
// finding, the deepest first.

namespace planish::job {
using namespace schema;
namespace {

/// Of the triangles from the solid, mm.
constexpr double kChord = 0.01;

/// What parts may share and still touch: rounding of files and gaps drawn as contact, and what the
/// triangles of two curved skins that touch share. No sheet is bent that precisely.
double contact_depth(double thickness) {
  constexpr double kLeast = 0.02;  // mm
  constexpr double kShare = 0.01;  // of the thickness
  return std::max(kLeast, kShare * thickness) + 2.0 * kChord;
}

/// The two parts of the sheet that come to lie at a point; the second is empty where only one is
/// near it, since the other thing there is a formed feature.
struct Meeting {
  MaterialPlace first;
  std::optional<MaterialPlace> second;
};

std::optional<Meeting> meeting_at(const Report& report, const Vec3& p) {
  // The neutral surface of a bend is not where the skins' middle is, and a mitre is not between the
  // skins along their normals.
  const double near = report.sheet.thickness;
  const auto places = material_places(report.sheet, report.layout, p, near);
  if (places.empty()) return std::nullopt;
  Meeting meeting{places.front(), {}};
  // Neighbouring faces name the same material twice, at places of the pattern that are as good as
  // the same.
  const double same = 0.5 * report.sheet.thickness;
  for (const MaterialPlace& other : places)
    if ((other.at - meeting.first.at).norm() > same) {
      meeting.second = other;
      break;
    }
  return meeting;
}

struct SharedSpace {
  double depth = 0.0;
  std::vector<Vec2> at;
};

/// What passes through a sheet is as deep in it as it is thick. Square edges that meet in a corner
/// share less: a shop files them, or trims them in the blank.
Severity severity_of(double depth, double thickness) {
  constexpr double kThrough = 0.9;
  return depth < kThrough * thickness ? Severity::warning : Severity::error;
}

Finding meeting_of(const FlatPattern& flat, const std::pair<PartId, PartId>& parts,
                   const SharedSpace& shared) {
  const bool itself = parts.first == parts.second;
  const Severity severity = severity_of(shared.depth, flat.thickness);
  Facts facts{{"part", part_place(flat, parts.first)}, {"depth", shared.depth, unit::mm}};
  if (!itself) facts.emplace_back("part", part_place(flat, parts.second));
  return finding_of("self_intersection", severity,
                    severity == Severity::warning ? say::edges_press
                    : itself                      ? say::runs_through_itself
                                                  : say::run_through_each_other,
                    facts, shared.at);
}

Finding untested(const Error& error) {
  return finding_of("folded_solid", say::folded_untested, error);
}

Finding unnamed(const SelfIntersection& found, double thickness) {
  // The faces are those of the solid that was made, which no file has.
  return finding_of("self_intersection", severity_of(found.depth, thickness),
                    say::solid_through_itself,
                    {{"depth", found.depth, unit::mm},
                     {"at", place::point(found.centre)},
                     {"first", found.faces[0] + 1},
                     {"second", found.faces[1] + 1}},
                    {});
}

/// Whether edges that meet along a seam overlap there: square edges of a sheet that meet in a fold
/// do so on its inside, but not beyond the thickness.
bool lies_along(const std::vector<std::array<Vec3, 2>>& seams, const SelfIntersection& found,
                double thickness) {
  return std::ranges::any_of(seams, [&](const std::array<Vec3, 2>& seam) {
    const Vec3 along = seam[1] - seam[0];
    const double share = (found.centre - seam[0]).dot(along) / along.squaredNorm();
    const Vec3 nearest = seam[0] + std::clamp(share, 0.0, 1.0) * along;
    return (found.centre - nearest).norm() <= thickness;
  });
}

Finding seam_edges(const SharedSpace& shared) {
  return finding_of("seam_edges", Severity::info, say::seam_edges,
                    {{"depth", shared.depth, unit::mm}}, shared.at);
}

/// Where to look: about the places where faces meet, by as much as mitres and features reach.
std::vector<Box3> places_of(const std::vector<MeetingFaces>& meetings, double thickness) {
  std::vector<Box3> places;
  const Vec3 around = Vec3::Constant(thickness);
  for (const MeetingFaces& meeting : meetings)
    places.emplace_back(meeting.where.min() - around, meeting.where.max() + around);
  return places;
}

}  // namespace

std::vector<Finding> self_intersections(const Report& report, const FoldedBody& folded) {
  if (report.sheet.bends.empty()) return {};
  const double thickness = report.sheet.thickness, depth = contact_depth(thickness);
  const auto meetings = meeting_faces(folded.sheet, depth);
  if (meetings.empty()) return {};
  const auto surface = body_faces_mesh(folded.body, kChord);
  if (!surface) return {untested(surface.error())};
  std::map<std::pair<PartId, PartId>, SharedSpace> by_parts;
  SharedSpace along_seams;
  std::vector<Finding> elsewhere;
  for (const SelfIntersection& found :
       find_self_intersections(*surface, depth, places_of(meetings, thickness))) {
    const auto meeting = meeting_at(report, found.centre);
    if (!meeting) {
      elsewhere.push_back(unnamed(found, thickness));
      continue;
    }
    const MaterialPlace &first = meeting->first, &second = meeting->second.value_or(first);
    SharedSpace& shared = lies_along(folded.seams, found, thickness)
                              ? along_seams
                              : by_parts[std::minmax(first.part, second.part)];
    shared.depth = std::max(shared.depth, found.depth);
    shared.at.push_back(first.at);
    if (meeting->second) shared.at.push_back(second.at);
  }
  std::vector<std::pair<std::pair<PartId, PartId>, SharedSpace>> order(by_parts.begin(),
                                                                       by_parts.end());
  std::ranges::stable_sort(order, std::greater(), [](const auto& one) { return one.second.depth; });
  std::vector<Finding> findings;
  for (const auto& [parts, shared] : order)
    findings.push_back(meeting_of(report.flat, parts, shared));
  findings.insert(findings.end(), elsewhere.begin(), elsewhere.end());
  if (along_seams.depth > 0.0) findings.push_back(seam_edges(along_seams));
  return findings;
}

}  // namespace planish::job
