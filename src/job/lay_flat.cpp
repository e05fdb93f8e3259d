#include "lay_flat.hpp"

#include "bending.hpp"
#include "plan_report.hpp"
#include "refusals.hpp"
#include "reliefs.hpp"
#include "self_intersections.hpp"
#include "sentences.hpp"
#include "taken_shop.hpp"
#include "verdict.hpp"

#include <planish/base/text.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/brake/bend_numbers.hpp>
#include <planish/inspect/double_cover.hpp>
#include <planish/inspect/findings.hpp>
#include <planish/sheet/codes.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

// From a sheet to the finished report, the same for every maker: pattern, certificate, overlaps,
// reliefs, rules, plan of strokes. A pattern that the certificate disproves never comes out, one
// with an error only if that is asked for. The certificate is that of the pattern before reliefs;
// the area that these take is checked on its own and corrects the ratios (math.md#reliefs). A draft
// stops after the pattern.

namespace planish::job {
using namespace shop;
namespace {

constexpr double kCubicDecimetre = 1e6;  // mm³

// Bends from one table row may differ in the last digits; that still counts as one K.
constexpr double kSameK = tolerance::kComputed;

Error stopped() { return error_of(refuse::cancelled, {}); }

void summarize_k(SheetSummary& summary, const FlatPattern& flat, const AllowanceRule& rule) {
  summary.k_factor.reset();
  summary.k_source.clear();
  if (flat.bends.empty()) {
    if (const auto* constant = std::get_if<ConstantK>(&rule)) {
      summary.k_factor = constant->k;
      summary.k_source = constant->source;
    }
    return;
  }
  const BendAllowance& first = flat.bends.front().allowance;
  summary.k_factor = first.k_factor;
  summary.k_source = first.source;
  for (const FlatBend& bend : flat.bends) {
    if (std::abs(bend.allowance.k_factor - first.k_factor) > kSameK) summary.k_factor.reset();
    if (bend.allowance.source != first.source) summary.k_source = "mixed";
  }
  if (!summary.k_factor) summary.k_source = "mixed";
}

std::optional<double> mass_of(const Report& report, std::optional<double> density) {
  if (!density) return std::nullopt;
  const double solid = report.summary.volume;
  const double volume = solid > 0.0 ? solid : report.flat.area * report.summary.thickness;
  return *density * volume / kCubicDecimetre;
}

void append(std::vector<Finding>& all, std::vector<Finding> more) {
  for (Finding& finding : more)
    all.push_back(std::move(finding));
}

void take_pattern(Report& report, FlatSheet flat, const SheetToLay& given,
                  const FlattenOptions& options) {
  report.flat = std::move(flat.pattern);
  report.layout = std::move(flat.layout);
  report.laid = options;
  report.size = blank_size(report.flat);
  report.mass = mass_of(report, given.checks.density ? given.checks.density : report.density);
  summarize_k(report.summary, report.flat, options.allowance);
}

std::optional<Error> lay_draft(Report& report, const SheetToLay& given, FlattenOptions options) {
  constexpr double kSeen = 1e-3;  // mm; a pixel is far wider
  options.curve_tolerance = std::max(options.curve_tolerance, kSeen);
  auto flat = flat_sheet(given.sheet, options);
  if (!flat) return flat.error();
  take_pattern(report, std::move(*flat), given, options);
  return std::nullopt;
}

// Returns what is wrong; the report holds what was found before.
std::optional<Error> lay_and_certify(Report& report, const SheetToLay& given,
                                     const FlattenOptions& options, const Progress& progress) {
  progress.at("laying it flat", 0.5);
  auto flat = flat_sheet(given.sheet, options);
  if (!flat) return flat.error();
  if (progress.should_stop()) return stopped();

  progress.at("certifying", 0.7);
  const auto certificate = certify(given.sheet, flat->pattern, given.distance,
                                   options.curve_tolerance);
  if (!certificate) return certificate.error();
  report.certificate = *certificate;
  const double volume = given.sheet.volume.value_or(0.0);
  const CertificateBounds& bounds = given.checks.bounds;
  // A wrong pattern is never returned.
  if (auto wrong = disbelief(*certificate, volume, bounds)) return wrong;

  take_pattern(report, std::move(*flat), given, options);
  append(report.findings, doubts(*certificate, report.flat, volume, bounds));
  return std::nullopt;
}

Rules rules_of(const SheetToLay& given) {
  const Rules& usual = given.checks.rules;
  const std::optional<ShopChoice>& shop = given.checks.shop;
  return shop ? rules_with_gauge(usual, *shop, given.sheet.thickness) : usual;
}

/// The pattern with its reliefs, and the certificate's areas with it.
void take_reliefs(Report& report, Relieved relieved) {
  report.flat = std::move(relieved.pattern);
  report.reliefs = std::move(relieved.cutouts);
  if (relieved.removed > 0.0) report.size = blank_size(report.flat);
  Certificate& certificate = report.certificate;
  if (certificate.volume_ratio)
    *certificate.volume_ratio *= 1.0 - relieved.removed / certificate.flat_area_half;
  certificate.flat_area_half -= relieved.removed;
  // What lies on another part when flat may close its opening when folded, as lanced tabs do: then
  // the solid has one less.
  const int extra = -certificate.openings.lost().value_or(0);
  if (extra > 0 && extra <= relieved.mended)
    std::erase_if(report.findings,
                  [](const Finding& finding) { return finding.code == "extra_opening"; });
  append(report.findings, std::move(relieved.findings));
}

/// Mends small overlaps and draws slits once, if that is wanted. Returns why it cannot be done.
std::optional<Error> relieve(Report& report, const SheetToLay& given,
                             std::vector<Finding>& overlaps) {
  const bool mends = given.relief.shape != Relief::none;
  if (!mends && given.relief.beside_bends == Relief::none) return std::nullopt;
  std::vector<DoubleCover> covers;
  if (mends && !overlaps.empty()) covers = double_covers(given.sheet, report.layout, report.flat);
  auto relieved = with_reliefs(given.sheet, report.layout, report.flat, covers, given.relief,
                               rules_of(given));
  if (!relieved) return relieved.error();
  if (mends && !overlaps.empty() && !contour_crossings(relieved->pattern).empty())
    return error_of(refuse::contours_cross, {});
  take_reliefs(report, std::move(*relieved));
  if (mends) overlaps.clear();
  return std::nullopt;
}

/// Where reliefs were declined and would mend all overlaps, they are what helps.
void offer_reliefs(std::vector<Finding>& overlaps, const Report& report, const SheetToLay& given) {
  if (!given.takes_relief || given.relief.shape != Relief::none || overlaps.empty()) return;
  ReliefOptions tried = given.relief;
  tried.shape = Relief::rip;
  tried.beside_bends = Relief::none;
  const auto relieved = with_reliefs(given.sheet, report.layout, report.flat,
                                     double_covers(given.sheet, report.layout, report.flat), tried,
                                     rules_of(given));
  if (!relieved || !contour_crossings(relieved->pattern).empty()) return;
  const std::vector<Remedy> reliefs{{"relief", "rip", "Cut a rip"},
                                    {"relief", "square", "Cut a square relief"},
                                    {"relief", "round", "Cut a round relief"}};
  for (Finding& overlap : overlaps)
    overlap.remedies.insert(overlap.remedies.begin(), reliefs.begin(), reliefs.end());
}

/// Why an overlap stays.
Error no_relief_because(Error why) {
  why.message = continued(std::move(why.message));
  say_before(why, "No relief mends it: ");
  return why;
}

std::optional<Error> inspect_pattern(Report& report, const SheetToLay& given) {
  std::vector<Finding> overlaps = find_overlaps(given.sheet, report.layout, report.flat);
  const auto unmended = relieve(report, given, overlaps);
  if (unmended && overlaps.empty()) return unmended;  // rips that cannot be cut
  offer_reliefs(overlaps, report, given);
  append(report.findings, overlaps);
  if (!given.checks.write_overlapping && !given.checks.write_anyway) {
    if (auto refusal = overlap_refusal(overlaps)) {
      if (unmended) say_after(*refusal, no_relief_because(*unmended));
      return refusal;
    }
  }
  if (given.folded) append(report.findings, self_intersections(report, *given.folded));
  if (auto doubt = size_doubt(report.summary.thickness, report.size.x()))
    report.findings.push_back(std::move(*doubt));
  const std::optional<ShopChoice>& shop = given.checks.shop;
  if (given.checks.rules.enabled)
    append(report.findings, check_rules(given.sheet, report.flat, rules_of(given)));
  if (shop)
    append(report.findings,
           shop_findings({report.summary.thickness, report.size, report.flat}, *shop));
  return error_refusal(report.findings, given.checks);
}

/// The bends that a plan makes with a radius that is told besides the drawn one.
std::vector<MadeFlat::Row> made_otherwise(const Report& report) {
  std::vector<MadeFlat::Row> rows;
  for (const Stroke& stroke : report.plan->strokes)
    for (const BendId bend : stroke.bends)
      if (is_made_otherwise(stroke, report.sheet.thickness) &&
          std::ranges::find(rows, bend, &MadeFlat::Row::bend) == rows.end())
        rows.push_back({bend, stroke.radius_drawn, stroke.radius_made});
  return rows;
}

/// Lays the sheet flat once more, for radii that a plan makes instead of the drawn ones; certified
/// and inspected as the drawn one.
Result<Report> laid_for(const std::vector<MadeFlat::Row>& rows, const Report& drawn,
                        const SheetToLay& given, const Progress& progress) {
  FlattenOptions options = drawn.laid;
  options.root = drawn.layout.root;
  options.up = drawn.layout.shows_reference(drawn.sheet) ? UpSide::reference : UpSide::other;
  for (const MadeFlat::Row& row : rows)
    options.made_radius.emplace_back(row.bend, row.made);
  Report made;
  made.sheet = given.sheet;
  if (auto error = lay_and_certify(made, given, options, progress)) return tl::unexpected(*error);
  std::vector<Finding> overlaps = find_overlaps(given.sheet, made.layout, made.flat);
  if (auto error = relieve(made, given, overlaps)) return tl::unexpected(*error);
  if (auto refusal = overlap_refusal(overlaps)) return tl::unexpected(*refusal);
  // The layout takes what the flanges give with what the bend takes; a bend table tells the bend's.
  for (FlatBend& bend : made.flat.bends)
    for (const MadeFlat::Row& row : rows)
      if (bend.bend == row.bend) {
        auto own = allowance_of_radius(given.sheet, row.bend, row.made, options);
        if (!own) return pass_on(own);
        bend.inside_radius = row.made;
        bend.allowance = std::move(*own);
      }
  return made;
}

/// The pattern of `made` in the report of the plan.
void take_made(Report& report, std::vector<MadeFlat::Row> rows, const Report& drawn, Report made) {
  for (MadeFlat::Row& row : rows)
    row.change = made.layout.allowance[row.bend].allowance -
                 drawn.layout.allowance[row.bend].allowance;
  number_bends(made.flat, *report.plan);
  report.as_made = MadeFlat{std::move(made.flat), made.size, std::move(rows)};
}

/// Puts the pattern of `made` in the place of the drawn one, and plans over it.
std::optional<Error> plan_over(const Report& made, Report& report, const Bending& bending,
                               const Progress& progress) {
  report.flat = made.flat;
  report.layout = made.layout;
  report.size = made.size;
  report.reliefs = made.reliefs;
  report.certificate = made.certificate;
  if (auto refusal = plan_strokes(report, bending, progress)) return refusal;
  if (has_order(*report.plan)) return std::nullopt;
  const StrokeLimits& limits = bending.plan.limits;
  if (std::chrono::steady_clock::now() < limits.until) return error_of(refuse::no_plan_as_made, {});
  return error_of(refuse::no_time_as_made, {{"seconds", limits.seconds, unit::seconds}});
}

/// The pattern for the radii that the plan makes; if the plan is to be over that, the report
/// becomes that of the pattern and a plan that agree. `drawn` has no plan yet. Returns why there is
/// none.
std::optional<Error> lay_as_made(Report& report, const Report& drawn, const SheetToLay& given,
                                 const Progress& progress) {
  constexpr int kMostRounds = 4;
  std::vector<MadeFlat::Row> rows = made_otherwise(report);
  if (rows.empty()) return std::nullopt;
  for (int round = 0; round < kMostRounds; ++round) {
    auto made = laid_for(rows, drawn, given, progress);
    if (!made) return made.error();
    if (!given.checks.bending.as_made) {
      take_made(report, std::move(rows), drawn, std::move(*made));
      return std::nullopt;
    }
    Report over = drawn;
    if (auto error = plan_over(*made, over, given.checks.bending, progress)) return error;
    auto then = made_otherwise(over);
    const bool agree = std::ranges::equal(then, rows, [](const auto& a, const auto& b) {
      return a.bend == b.bend && a.made == b.made;
    });
    if (agree) {
      report = std::move(over);
      take_made(report, std::move(rows), drawn, std::move(*made));
      return std::nullopt;
    }
    rows = std::move(then);
  }
  return error_of(refuse::made_otherwise_again, {});
}

}  // namespace

SheetSummary summary_of(const Sheet& sheet) {
  SheetSummary summary;
  summary.thickness = sheet.thickness;
  summary.thickness_spread = sheet.thickness_spread;
  summary.volume = sheet.volume.value_or(0.0);
  summary.flanges = static_cast<int>(sheet.flanges.size());
  summary.bends = static_cast<int>(sheet.bends.size());
  return summary;
}

std::optional<Error> lay_flat(Report& report, const SheetToLay& given,
                              const FlattenOptions& options, const Progress& progress) {
  if (progress.should_stop()) return stopped();
  report.sheet = given.sheet;
  if (given.checks.effort == Effort::draft) return lay_draft(report, given, options);
  if (auto error = lay_and_certify(report, given, options, progress)) return error;
  if (progress.should_stop()) return stopped();
  progress.at("checking", 0.9);
  if (auto refusal = inspect_pattern(report, given)) return refusal;
  const Bending& bending = given.checks.bending;
  const Report drawn = bending.ask == Bending::Ask::plan ? report : Report();
  if (auto refusal = plan_strokes(report, bending, progress)) return refusal;
  if (!report.plan) return std::nullopt;
  report.not_as_made = lay_as_made(report, drawn, given, progress);
  if (report.not_as_made)
    report.notes.push_back(
        in_units(tell(say::no_made_flat, {{"why", words_of(*report.not_as_made)}}), report.units)
            .sentence);
  return std::nullopt;
}

void say_in_its_units(Report& report) {
  for (Finding& finding : report.findings)
    finding = in_units(std::move(finding), report.units);
  if (report.refusal) report.refusal = in_units(std::move(*report.refusal), report.units);
}

Result<void> lies_uncovered(const Sheet& sheet, const FlattenOptions& options,
                            const Progress& progress) {
  if (progress.should_stop()) return tl::unexpected(stopped());
  auto flat = flat_sheet(sheet, options);
  if (!flat) return pass_on(flat);
  Report report;
  const EdgeDistance unmeasured;
  const Request plain;
  const SheetToLay given{sheet, unmeasured, plain, {}, plain.relief};
  take_pattern(report, std::move(*flat), given, options);
  std::vector<Finding> overlaps = find_overlaps(sheet, report.layout, report.flat);
  if (!overlaps.empty()) relieve(report, given, overlaps);
  if (auto refusal = overlap_refusal(overlaps)) return tl::unexpected(*refusal);
  return {};
}

Result<Recognized> found_sheet(const Body& body, RecognizeOptions options,
                               const Progress& progress) {
  const FlattenOptions layout{.allowance = ConstantK{0.5, "recognition"}};
  options.passes = [&](const Sheet& open) { return lies_uncovered(open, layout, progress); };
  return recognize(body, options);
}

RecognizeOptions sought_by(const Request& request) {
  return {.rip_edges = request.rip_edges, .thickness = request.thickness};
}

}  // namespace planish::job
