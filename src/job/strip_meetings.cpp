#include "strip_meetings.hpp"

#include "sentences.hpp"

#include <planish/collision/meeting_faces.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <utility>

// Strips that need the same space. There is no solid, so the blocks of their faces are tested at
// growing shares of the thickness, and a pair counts as deep as the last that found it
// (math.md#self-intersection). At the last share strips run through each other; below, the edges of
// neighbours press on each other, which is information.

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
                               : text_of(place::strip(part.strip));
  return part.mirrored == beside.mirrored ? name : name + " of the other half";
}

std::string names_of(const Pair& pair) {
  const auto& [one, other] = pair;
  if (one == other) return name_of(one, one) + " runs through itself";
  if (one.strip == other.strip) return name_of(one, one) + " runs through its mirror image";
  return fmt::format("{} and {} run through each other", name_of(one, one), name_of(other, one));
}

/// The strips of a pair and how deep they meet.
Facts facts_of(const Pair& pair, double depth) {
  Facts facts{{"depth", depth, unit::mm}};
  for (const SlitPart& part : {pair.first, pair.second})
    if (part.strip != SlitPart::kPanel && part.strip != SlitPart::kSecondPanel)
      facts.emplace_back("strip", place::strip(part.strip));
  if (pair.first.strip == pair.second.strip && facts.size() > 2) facts.pop_back();
  return facts;
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
    Facts facts = facts_of(pair, depth);
    if (meeting.depth == kDepths.back()) {
      facts.emplace_back("meet", names_of(pair));
      findings.push_back(finding_of("self_intersection", Severity::error, say::strips_meet, facts,
                                    places(meeting)));
      continue;
    }
    facts.emplace_back("pair", name_of(pair.first, pair.first));
    facts.emplace_back("pair", name_of(pair.second, pair.first));
    Finding one = finding_of("strips_press", Severity::info, say::strips_press, facts,
                             places(meeting));
    pressed.push_back({one.severity, one.message, one.at, one.about, one.numbers, one.named});
  }
  if (pressed.empty()) return findings;
  const FindingPlace& worst = pressed.front();
  findings.push_back({"strips_press",
                      Severity::info,
                      worst.message,
                      worst.at,
                      pressed,
                      worst.places,
                      worst.numbers,
                      {},
                      worst.named});
  return findings;
}

}  // namespace planish::job
