#include "folded.hpp"
#include "from_file.hpp"
#include "lay_flat.hpp"
#include "made_report.hpp"
#include "refusals.hpp"
#include "slit_equilibrium.hpp"
#include "strip_meetings.hpp"
#include "verdict.hpp"

#include <planish/job/slit.hpp>
#include <planish/schema/units.hpp>
#include <planish/sheet/slots.hpp>
#include <planish/slit/codes.hpp>
#include <planish/slit/scans.hpp>

#include <fmt/format.h>

#include <algorithm>

// A slit file to its report. Strips are solved coarse first, each subdivision from the solution
// before (math.md#subdivision), then laid flat and certified. Facets keep the coordinates of the
// sheet that was cut, so one motion must map them all; `flat_deviation` is what is left. Scans
// placed roughly and strips follow each other until both are still. A strip that misses its end
// refuses the sheet.

namespace planish::job {
namespace {

/// All borders are straight hinges or cuts, so their images are exact (mm).
constexpr double kExactOutline = 1e-9;

Result<void> solve(SlitSession& session, const Progress& progress) {
  const auto done = session.solve({}, progress);
  return done ? Result<void>() : pass_on(done);
}

Result<SlitSession> solved(const SlitFile& file, SlitReport& report, const Progress& progress) {
  auto session = SlitSession::start(file.design);
  if (!session) return session;
  for (int level = 0; level <= file.subdivisions; ++level) {
    if (level > 0) session->subdivide();
    if (auto done = solve(*session, progress); !done) return pass_on(done);
    if (level > 0 || !(file.align_scans || has_cloud(file.design))) continue;
    const auto motion = follow_scans(*session, file.design, file.align_scans, {}, progress);
    if (!motion) return pass_on(motion);
    report.scan_motion = *motion;
  }
  return session;
}

void take_result(SlitReport& report, const SlitSession& session) {
  report.design = session.design();
  report.folded = session.folded();
  report.equilibrium = session.equilibrium();
  for (int strip = 0; strip < session.strip_count(); ++strip) {
    report.strips.push_back(session.state(strip));
    report.gap = std::max(report.gap, session.state(strip).gap);
  }
}

/// By how much the leg curves were scaled: lengths as solved and as in the file.
std::vector<double> leg_scales(const SlitDesign& solved, const SlitDesign& asked) {
  std::vector<double> scales{length(solved.leg_curve) / length(asked.leg_curve)};
  if (solved.second_panel && asked.second_panel)
    scales.push_back(length(solved.second_panel->leg_curve) /
                     length(asked.second_panel->leg_curve));
  return scales;
}

/// A refusal if strips do not reach the place where they must end.
std::optional<Error> out_of_reach(const SlitReport& report) {
  constexpr double kThere = 1e-6;  // mm
  constexpr int kMostNamed = 8;
  Facts facts;
  int count = 0;
  for (int i = 0; i < std::ssize(report.strips); ++i) {
    const StripState& strip = report.strips[static_cast<std::size_t>(i)];
    if (strip.status != StripStatus::out_of_reach) continue;
    if (strip.shortfall < kThere)
      return error_of(
          refuse::strip_turned,
          {{"strip", place::strip(i)},
           {"field", place::pointer(report.design.second_panel ? "/second_panel"
                                                               : fmt::format("/ends/{}", i))}});
    if (++count > kMostNamed) continue;
    facts.emplace_back("strip", place::strip(i));
    facts.emplace_back("shortfall", strip.shortfall, unit::mm);
    facts.emplace_back("field", place::pointer(fmt::format("/sheet/strips/{}", i)));
  }
  if (count == 0) return std::nullopt;
  facts.emplace_back("count", count);
  return error_of(count == 1            ? refuse::strip_short
                  : count <= kMostNamed ? refuse::strips_short
                                        : refuse::many_strips_short,
                  facts);
}

Vec2 flat_middle(const SlitReport& report, std::size_t strip, int ridge) {
  const SlitRidge& at = report.folded.strips[strip].ridges[ridge];
  return report.layout.placement.front() * Vec2(0.5 * (at.flat[0] + at.flat[1]));
}

double length_of(const SlitSheet& sheet, std::size_t strip) {
  const auto start = sheet.start_of(static_cast<int>(strip));
  return sheet.end_of(static_cast<int>(strip)) - std::min(start[0], start[1]);
}

constexpr double kFarOff = 0.1;   // from a scan, of a strip's length
constexpr double kUnseen = 1e-5;  // of a gap, likewise

/// A finding about a strip, at one of its ridges.
void add(SlitReport& report, const char* code, std::string_view pattern, std::size_t strip,
         int ridge, Facts facts = {}) {
  const Vec2 at = flat_middle(report, strip, ridge);
  facts.insert(facts.begin(), {"strip", place::at(place::strip(static_cast<int>(strip)), at)});
  report.findings.push_back(finding_of(code, Severity::warning, pattern, facts, {at}));
}

void add_tight(SlitReport& report, std::size_t i) {
  const StripState& strip = report.strips[i];
  const SlitSheet& sheet = report.design.sheet;
  const double inside = std::max(0.0, strip.min_radius - 0.5 * sheet.thickness);
  const Fact ridge("ridge", place::ridge(strip.tightest_ridge));
  if (strip.too_tight)
    add(report, "min_radius", say::strip_tight, i, strip.tightest_ridge,
        {{"radius", strip.min_radius, unit::mm}, ridge, {"least", sheet.min_radius(), unit::mm}});
  else if (inside < sheet.thickness)
    add(report, "creased", say::strip_creased, i, strip.tightest_ridge,
        {ridge, {"inside", inside, unit::mm}});
}

/// A gap to the next strip that is not as the coupling asks for.
void add_gap(SlitReport& report, std::size_t i, int last) {
  const auto& coupling = report.design.coupling;
  if (!coupling || !coupling->gap || i + 1 >= report.strips.size()) return;
  const double gap = gap_between(report.folded.strips[i], report.folded.strips[i + 1]);
  const double unseen = kUnseen * length_of(report.design.sheet, i);
  if (gap < (*coupling->gap)[0] - unseen || gap > (*coupling->gap)[1] + unseen)
    add(report, "gap_missed", say::gap_missed, i, last,
        {{"strip", place::strip(static_cast<int>(i) + 1)}, {"gap", gap, unit::mm}});
}

/// Findings about strips that end where they must.
void add_findings(SlitReport& report) {
  std::vector<Vec2> at;
  for (std::size_t i = 0; i < report.strips.size(); ++i) {
    const StripState& strip = report.strips[i];
    const int last = static_cast<int>(report.folded.strips[i].ridges.size()) - 1;
    add_tight(report, i);
    for (const int other : strip.crosses)
      add(report, "strips_cross", say::strips_cross, i, last / 2, {{"other", place::strip(other)}});
    if (strip.scan_distance > kFarOff * length_of(report.design.sheet, i))
      add(report, "scan_far", say::scan_far, i, last, {{"off", strip.scan_distance, unit::mm}});
    if (strip.crosses_plane) add(report, "strips_cross", say::crosses_image, i, last);
    if (strip.below_ground > 0.0)
      add(report, "below_ground", say::below_ground, i, last / 2,
          {{"deep", strip.below_ground, unit::mm}});
    add_gap(report, i, last);
    if (strip.status == StripStatus::open)
      add(report, "not_converged", say::not_converged, i, last / 2);
    at.push_back(flat_middle(report, i, strip.tightest_ridge));
  }
  for (Finding& finding : equilibrium_findings(report, at))
    report.findings.push_back(std::move(finding));
}

double flat_deviation(const Sheet& sheet, const Layout& layout) {
  double largest = 0.0;
  for (const FaceId id : sheet.faces.ids())
    for (const Border& border : sheet[id].loops.front()) {
      const Vec2 p = start_of(border.curve);
      largest = std::max(largest, (layout.placement[id] * p - layout.placement.front() * p).norm());
    }
  return largest;
}

/// Slots that cannot be cut are a mistake in the file, not on the command line.
Error at_kerf(Error error, const SlitFile& file) {
  if (error.code == code::bad_option) error.code = code::invalid_input;
  error.where = file.stop_hole > file.kerf ? "/stop_hole" : "/kerf";
  return error;
}

std::optional<Error> lay_solved(SlitReport& report, const SlitSession& session,
                                const SlitFile& file, const Request& request,
                                const Progress& progress) {
  const std::string name = place_name(report.input);
  take_result(report, session);
  report.leg_scales = leg_scales(report.design, file.design);
  if (auto missed = out_of_reach(report)) return placed(*missed, name);
  const Sheet sheet = sheet_of(report.folded);
  report.summary = summary_of(sheet);
  FlattenOptions options;
  options.allowance = ConstantK{0.5, "hinges of the middle surface"};
  options.curve_tolerance = options.merge_tolerance = kExactOutline;
  options.root = FaceId{0};  // its coordinates are the whole flat sheet's
  options.keep_root = true;
  options.up = UpSide::reference;
  PatternChecks checks = request;
  checks.rules.enabled = false;
  const EdgeDistance distance = checks.effort == Effort::full ? border_distance(sheet)
                                                              : EdgeDistance();
  if (auto wrong = lay_flat(report, {sheet, distance, checks}, options, progress)) return wrong;
  report.flat_deviation = flat_deviation(sheet, report.layout);
  if (checks.effort == Effort::full) {
    const auto meetings = strip_meetings(report, sheet);
    report.findings.insert(report.findings.end(), meetings.begin(), meetings.end());
  }
  add_findings(report);
  auto cut = cut_slits(std::move(report.flat), {file.kerf, file.stop_hole});
  if (!cut) return placed(at_kerf(cut.error(), file), name);
  report.flat = std::move(*cut);
  return error_refusal(report.findings, request);
}

std::optional<Error> fill(SlitReport& report, const SlitFile& file, const Request& request,
                          const Progress& progress) {
  const auto session = solved(file, report, progress);
  if (!session) return placed(session.error(), place_name(report.input));
  return lay_solved(report, *session, file, request, progress);
}

}  // namespace

Outcome<SlitReport> slit_solved(const SlitSession& session, const SlitFile& file,
                                const Request& request, const Progress& progress) {
  return reported(begun<SlitReport>(request, file.units), [&](SlitReport& report) {
    return lay_solved(report, session, file, request, progress);
  });
}

Outcome<SlitReport> slit_sheet(const SlitFile& file, const Request& request,
                               const Progress& progress) {
  return reported(begun<SlitReport>(request, file.units),
                  [&](SlitReport& report) { return fill(report, file, request, progress); });
}

Outcome<SlitReport> slit(const Request& request, const Progress& progress) {
  const auto parse = [](const InputFile& input) {
    return parse_slits(input.content, input.name, input.folder);
  };
  return from_file(request, "slit file", parse, slit_sheet, progress);
}

}  // namespace planish::job
