#include "verdict.hpp"

#include "facts.hpp"
#include "refusals.hpp"
#include "sentences.hpp"

#include <planish/base/assert.hpp>
#include <planish/base/text.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/sheet/pattern_facts.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

// What a certificate means (math.md#certificate, cli.md#unfold): a residual beyond its first bound
// is a finding with its place, beyond the second the pattern is refused as wrong. A finding that is
// an error refuses it too, unless the files are to be written all the same. The volume without
// forms decides if they could be measured, else the whole, with a wider bound. A ratio that is not
// a number refuses.

namespace planish::job {
namespace {

constexpr auto kSlantedCut = "slanted cut";
constexpr auto kChamfer = "chamfer";
constexpr double kMissed = 0.1;  // mm: of material that nobody misses

std::string place_text(const Vec2& p) {
  return fmt::format("flat pattern at ({}, {}) mm", trimmed_number(p.x(), 3),
                     trimmed_number(p.y(), 3));
}

/// The middles of features; of a chamfer, which goes round the material, a point of its edge.
std::vector<Vec2> feature_places(const FlatPattern& flat) {
  std::vector<Vec2> places;
  for (const FlatFeature& feature : flat.features) {
    places.insert(places.end(), feature.along.begin(), feature.along.end());
    if (feature.outlines.empty()) continue;
    const Loop& outline = feature.outlines.front();
    const Box2 box = bounds(outline);
    places.push_back(feature.kind == kChamfer ? point_at(outline.front(), 0.5)
                                              : Vec2(0.5 * (box.lo + box.hi)));
  }
  return places;
}

bool off(double ratio, double bound) { return std::abs(ratio - 1.0) > bound; }

Finding volume_doubt(const Certificate& certificate, const FlatPattern& flat,
                     const CertificateBounds& bounds) {
  const double bound = bounds.volume_warning, ratio = or_nan(certificate.volume_ratio);
  const std::string features = forms_text(flat);
  const double explained = or_nan(certificate.explained_ratio);
  Facts facts{{"ratio", ratio, unit::none}, {"allowed", bound, unit::none}, {"forms", features}};
  std::string pattern(say::volume_off);
  if (!features.empty()) pattern += say::because_of_forms;
  if (std::isfinite(explained) && explained != ratio) {
    pattern += features.empty() ? say::without_mitres : say::without_forms;
    facts.emplace_back("explained", explained, unit::none);
  }
  if (features.empty() || off(explained, bound)) {
    pattern += say::slanted_or_missed;
    if (certificate.opening_error && *certificate.opening_error <= bounds.opening_warning)
      pattern += say::openings_fit;
  }
  return finding_of("volume_identity", Severity::warning, pattern, facts, feature_places(flat));
}

Finding residual_doubt(const std::string& code, std::string_view sentence, double value,
                       double bound, const Vec2& at) {
  return finding_of(
      code, Severity::warning, sentence,
      {{"off", value, unit::mm}, {"allowed", bound, unit::mm}, {"at", place::point(at)}}, {at});
}

Error wrong(const Refusal& refusal, double off, const Vec2& at) {
  return error_of(refusal, {{"off", off, unit::mm}, {"at", place::point(at)}}, place_text(at));
}

std::optional<Finding> opening_doubt(const OpeningCount& openings) {
  const int lost = openings.lost().value_or(0);
  if (lost == 0) return std::nullopt;
  const Facts counts{{"solid", *openings.solid},
                     {"pattern", *openings.solid - lost},
                     {lost < 0 ? "extra" : "lost", std::abs(lost)}};
  if (lost < 0)
    return finding_of("extra_opening", Severity::error, say::extra_openings, counts, {});
  return finding_of("lost_opening", Severity::error,
                    lost == 1 ? say::one_opening_lost : say::openings_lost, counts,
                    openings.missing);
}

/// A finding about so many of a kind.
Finding counting(std::string code, std::string_view pattern, std::size_t count,
                 std::vector<Vec2> at, Facts facts = {}) {
  facts.emplace_back("count", count);
  facts.emplace_back("are", count == 1 ? "is" : "are");
  for (const Vec2& p : at)
    facts.emplace_back("at", place::point(p));
  return finding_of(std::move(code), Severity::info, pattern, facts, std::move(at));
}

void add_slanted_cuts(std::vector<Finding>& found, const FlatPattern& flat, double least) {
  std::vector<Vec2> places;
  double beyond = 0.0, within = 0.0;
  for (const FlatFeature& feature : flat.features) {
    if (feature.kind != kSlantedCut) continue;
    beyond = std::max(beyond, feature.beyond_cut.value_or(0.0));
    within = std::max(within, -feature.beyond_cut.value_or(0.0));
    places.insert(places.end(), feature.along.begin(), feature.along.end());
    if (feature.outlines.empty()) continue;
    const Box2 box = bounds(feature.outlines.front());
    places.push_back(0.5 * (box.lo + box.hi));
  }
  if (places.empty()) return;
  std::string pattern(say::slanted_cuts);
  if (beyond > least || within > least)
    pattern += within <= least   ? say::slanted_beyond
               : beyond <= least ? say::slanted_within
                                 : say::slanted_both;
  Facts facts;
  if (beyond > least) facts.emplace_back("beyond", beyond, unit::mm);
  if (within > least) facts.emplace_back("within", within, unit::mm);
  const std::size_t count = places.size();
  found.push_back(counting("slanted_cut", pattern, count, std::move(places), std::move(facts)));
  if (beyond > kMissed) found.back().severity = Severity::warning;
}

void add_form_notes(std::vector<Finding>& found, const FlatPattern& flat) {
  std::vector<Vec2> pilots, uncut;
  std::size_t count = 0;
  for (const FlatFeature& feature : flat.features) {
    pilots.insert(pilots.end(), feature.pilots.begin(), feature.pilots.end());
    if (feature.uncut_openings == 0) continue;
    count += static_cast<unsigned>(feature.uncut_openings);
    if (feature.outlines.empty()) continue;
    const Box2 box = bounds(feature.outlines.front());
    uncut.push_back(0.5 * (box.lo + box.hi));
  }
  if (!pilots.empty())
    found.push_back(counting("pilot_hole", say::pilot_holes, pilots.size(), pilots));
  if (count > 0) found.push_back(counting("uncut_opening", say::uncut_openings, count, uncut));
}

/// The refusal for the first of so many findings.
Error refusal_with(const Refusal& refusal, const Finding& first, Facts facts) {
  Told what = words_of(first);
  what.sentence = capitalized(std::move(what.sentence));
  facts.emplace_back("what", std::move(what));
  Error error = error_of(refusal, facts,
                         first.at.empty() ? std::string() : place_text(first.at.front()));
  error.places = first.about;
  error.numbers = first.numbers;
  error.remedies = first.remedies;
  return error;
}

/// An error refuses under its own code; an overlap has refused before.
const Refusal* refusal_of(const Finding& finding) {
  if (finding.severity != Severity::error) return nullptr;
  for (const Refusal* refusal :
       {&refuse::opening_lost, &refuse::opening_too_many, &refuse::runs_through})
    if (refusal->code.name == finding.code) return refusal;
  PLANISH_ASSERT(finding.code == code::overlap.name);
  return nullptr;
}

}  // namespace

std::vector<Finding> doubts(const Certificate& certificate, const FlatPattern& flat,
                            double solid_volume, const CertificateBounds& bounds) {
  std::vector<Finding> found;
  if (auto doubt = opening_doubt(certificate.openings)) found.push_back(std::move(*doubt));
  const bool explained = !off(or_nan(certificate.explained_ratio), bounds.volume_warning);
  const bool measured = std::isfinite(or_nan(certificate.explained_ratio));
  if (solid_volume > 0.0 && !(measured && explained) &&
      (measured || off(or_nan(certificate.volume_ratio), bounds.volume_warning)))
    found.push_back(volume_doubt(certificate, flat, bounds));
  if (certificate.opening_error.value_or(0.0) > bounds.opening_warning)
    found.push_back(residual_doubt("opening_size", say::opening_off, *certificate.opening_error,
                                   bounds.opening_warning, certificate.opening_error_at));
  if (certificate.outline_error.value_or(0.0) > bounds.opening_warning)
    found.push_back(residual_doubt("outline_size", say::outline_off, *certificate.outline_error,
                                   bounds.opening_warning, certificate.outline_error_at));
  if (certificate.length_error > bounds.length_warning) {
    found.push_back(residual_doubt("edge_length", say::length_off, certificate.length_error,
                                   bounds.length_warning, certificate.length_error_at));
  }
  if (or_nan(certificate.refold_deviation) > bounds.refold_warning) {
    found.push_back(residual_doubt("refold", say::refold_off, or_nan(certificate.refold_deviation),
                                   bounds.refold_warning, certificate.refold_at));
  }
  add_slanted_cuts(found, flat, bounds.opening_warning);
  add_form_notes(found, flat);
  return found;
}

std::optional<Error> disbelief(const Certificate& certificate, double solid_volume,
                               const CertificateBounds& bounds) {
  const bool measured = std::isfinite(or_nan(certificate.explained_ratio));
  const double ratio = measured ? or_nan(certificate.explained_ratio)
                                : or_nan(certificate.volume_ratio);
  const double bound = measured ? bounds.volume_refusal : bounds.unmeasured_refusal;
  // The negated comparison also catches a ratio that is not a number.
  if (solid_volume > 0.0 && !(std::abs(ratio - 1.0) <= bound)) {
    return error_of(refuse::volume_wrong,
                    {{"ratio", ratio, unit::none}, {"allowed", bound, unit::none}});
  }
  if (certificate.length_error > bounds.length_refusal) {
    return wrong(refuse::length_wrong, certificate.length_error, certificate.length_error_at);
  }
  if (certificate.opening_error.value_or(0.0) > bounds.opening_refusal) {
    return wrong(refuse::opening_wrong, *certificate.opening_error, certificate.opening_error_at);
  }
  if (certificate.outline_error.value_or(0.0) > bounds.opening_refusal) {
    return wrong(refuse::outline_wrong, *certificate.outline_error, certificate.outline_error_at);
  }
  if (or_nan(certificate.refold_deviation) > bounds.refold_refusal) {
    return wrong(refuse::refold_wrong, or_nan(certificate.refold_deviation), certificate.refold_at);
  }
  return std::nullopt;
}

std::optional<Finding> size_doubt(double thickness, double blank_length) {
  // mm. Foil and shim begin at 0.01; plate is rolled up to some 300, and up to 25 m long.
  constexpr double kThinnest = 0.01, kThickest = 400.0, kShortest = 0.5, kLongest = 30'000.0;
  if (thickness >= kThinnest && thickness <= kThickest && blank_length >= kShortest &&
      blank_length <= kLongest)
    return std::nullopt;
  return finding_of("unlikely_size", Severity::warning, say::size_unlikely,
                    {{"thickness", thickness, unit::mm}, {"length", blank_length, unit::mm}}, {});
}

std::optional<Error> overlap_refusal(const std::vector<Finding>& overlaps) {
  if (overlaps.empty()) return std::nullopt;
  return refusal_with(
      overlaps.size() > 1 ? refuse::pattern_overlaps_more : refuse::pattern_overlaps,
      overlaps.front(), {{"more", overlaps.size() - 1}});
}

std::optional<Error> error_refusal(const std::vector<Finding>& findings,
                                   const PatternChecks& checks) {
  if (checks.write_anyway) return std::nullopt;
  const auto refuses = [](const Finding& finding) { return refusal_of(finding) != nullptr; };
  const auto first = std::ranges::find_if(findings, refuses);
  if (first == findings.end()) return std::nullopt;
  const auto more = std::ranges::count_if(first + 1, findings.end(), refuses);
  std::string others;
  if (more > 0)
    others = tell(say::more_errors, {{"more", more}, {"are", more == 1 ? "is" : "are"}}).sentence;
  Error error = refusal_with(*refusal_of(*first), *first, {{"others", others}});
  error.remedies.push_back({"write_anyway", "true", "Write it anyway"});
  return error;
}

}  // namespace planish::job
