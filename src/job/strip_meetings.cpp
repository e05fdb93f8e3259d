#include "strip_meetings.hpp"

#include <planish/collision/meeting_faces.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <utility>

namespace planish::job {
namespace {

/// Depths that are tried, of the thickness. Strips that reach the last run through each other.
constexpr std::array kDepths{0.25, 0.5, 0.75, 0.9};

using Pair = std::pair<SlitPart, SlitPart>;

struct StripMeeting {
  double depth = 0.0;  ///< of the deepest that was found, of the thickness
  std::array<FaceId, 2> faces{};
};

/// Parts on one side, and each two sides once: mirrored pairs meet where the others do.
Pair pair_of(SlitPart a, SlitPart b) {
  if (a.mirrored && b.mirrored) a.mirrored = b.mirrored = false;
  if (a.mirrored != b.mirrored && b < a) {
    a.mirrored = !a.mirrored;
    b.mirrored = !b.mirrored;
  }
  return std::minmax(a, b);
}

std::map<Pair, StripMeeting> meetings_of(const FoldedSlitSheet& folded, const Sheet& sheet) {
  const auto parts = parts_of(folded);
  std::map<Pair, StripMeeting> deepest;
  for (const double depth : kDepths) {
    const auto found = meeting_faces(sheet, depth * sheet.thickness);
    if (found.empty()) break;
    for (const MeetingFaces& one : found)
      deepest[pair_of(parts[one.faces[0]], parts[one.faces[1]])] = {depth, one.faces};
  }
  return deepest;
}

std::string name_of(const SlitPart& part, const SlitPart& beside) {
  const std::string name = part.strip == SlitPart::kPanel ? "the panel"
                           : part.strip == SlitPart::kSecondPanel
                               ? "the second panel"
                               : fmt::format("strip {}", part.strip);
  return part.mirrored == beside.mirrored ? name : name + " of the other half";
}

std::string names_of(const Pair& pair) {
  const auto& [one, other] = pair;
  if (one == other) return name_of(one, one) + " runs through itself";
  if (one.strip == other.strip) return name_of(one, one) + " runs through its mirror image";
  return fmt::format("{} and {} run through each other", name_of(one, one), name_of(other, one));
}

Vec2 middle_of(const Box2& box) { return 0.5 * (box.lo + box.hi); }

Vec2 middle_of(const SlitReport& report, const Sheet& sheet, FaceId face) {
  return report.layout.develop(sheet, face, middle_of(parameter_box(sheet[face])));
}

}  // namespace

std::vector<Finding> strip_meetings(const SlitReport& report, const Sheet& sheet) {
  const auto places = [&](const StripMeeting& meeting) {
    return std::vector<Vec2>{middle_of(report, sheet, meeting.faces[0]),
                             middle_of(report, sheet, meeting.faces[1])};
  };
  std::vector<Finding> findings;
  std::vector<FindingPlace> pressed;
  const auto found = meetings_of(report.folded, sheet);
  std::vector<std::pair<Pair, StripMeeting>> deepest_first(found.begin(), found.end());
  std::ranges::stable_sort(deepest_first, std::greater(),
                           [](const auto& one) { return one.second.depth; });
  for (const auto& [pair, meeting] : deepest_first) {
    const double depth = meeting.depth * sheet.thickness;
    if (meeting.depth == kDepths.back())
      findings.push_back(
          {"self_intersection", Severity::error,
           fmt::format("{} when folded, {:.3g} mm deep or more", names_of(pair), depth),
           places(meeting)});
    else
      pressed.push_back(
          {Severity::info,
           fmt::format("{} and {} need the same space, {:.3g} mm deep or more: move "
                       "their curves apart, or chamfer their edges",
                       name_of(pair.first, pair.first), name_of(pair.second, pair.first), depth),
           places(meeting)});
  }
  if (pressed.empty()) return findings;
  findings.push_back(
      {"strips_press", Severity::info, pressed.front().message, pressed.front().at, pressed});
  return findings;
}

}  // namespace planish::job
