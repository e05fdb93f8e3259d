#include "facts.hpp"
#include "sides.hpp"
#include "verdict.hpp"

#include <planish/brep/step.hpp>
#include <planish/inspect/findings.hpp>
#include <planish/job/unfold.hpp>

#include <chrono>
#include <cmath>

namespace planish::job {
namespace {

constexpr double kCubicDecimetre = 1e6;  // mm³
constexpr int kRefusedStatus = 4;        // FORMATS, "Exit status"

// Bends of one table row may differ in the last digits; that is still one K.
constexpr double kSameK = 1e-9;

Error stopped() { return {ErrorCode::cancelled, "cancelled", {}}; }

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

SheetSummary summary_of(const Sheet& sheet) {
  SheetSummary summary;
  summary.thickness = sheet.thickness;
  summary.thickness_spread = sheet.thickness_spread;
  summary.volume = sheet.volume;
  summary.flanges = static_cast<int>(sheet.flanges.size());
  summary.bends = static_cast<int>(sheet.bends.size());
  return summary;
}

std::optional<double> mass_of(const UnfoldReport& report, std::optional<double> density) {
  if (!density) return std::nullopt;
  const double solid = report.sheet.volume;
  const double volume = solid > 0.0 ? solid : report.flat.area * report.sheet.thickness;
  return *density * volume / kCubicDecimetre;
}

void append(std::vector<Finding>& all, std::vector<Finding> more) {
  for (Finding& finding : more)
    all.push_back(std::move(finding));
}

// Lays the sheet flat and certifies it; what is wrong comes back, what is known is in the report.
std::optional<Error> lay_flat(UnfoldReport& report, const Recognized& found,
                              const UnfoldRequest& request, const Progress& progress) {
  const auto options = flatten_options(found.sheet, request);
  if (!options) return options.error();
  progress.at("laying it flat", 0.5);
  auto flat = flatten(found.sheet, *options);
  if (!flat) return flat.error();
  if (progress.should_stop()) return stopped();

  progress.at("certifying", 0.7);
  const auto certificate = certify(found.sheet, *flat, found.distance, *options);
  if (!certificate) return certificate.error();
  report.certificate = *certificate;
  // A pattern that is wrong is not handed out at all.
  if (auto wrong = disbelief(*certificate, found.sheet.volume, request.bounds)) return wrong;

  report.flat = std::move(*flat);
  report.size = blank_size(report.flat);
  report.mass = mass_of(report, request.density);
  summarize_k(report.sheet, report.flat, request.allowance);
  append(report.findings, doubts(*certificate, report.flat, found.sheet.volume, request.bounds));
  return std::nullopt;
}

std::optional<Error> inspect(UnfoldReport& report, const Sheet& sheet,
                             const UnfoldRequest& request) {
  const std::vector<Finding> overlaps = find_overlaps(sheet, report.flat);
  append(report.findings, overlaps);
  if (!request.write_overlapping) {
    if (auto refusal = overlap_refusal(overlaps)) return refusal;
  }
  if (request.rules.enabled) {
    append(report.findings, check_rules(sheet, report.flat, request.rules));
  }
  return std::nullopt;
}

std::optional<Error> fill(UnfoldReport& report, const Body& body, const UnfoldRequest& request,
                          const Progress& progress) {
  progress.at("finding the sheet", 0.2);
  auto found = recognize(body);
  if (!found) return found.error();
  report.sheet = summary_of(found->sheet);
  report.notes = std::move(found->notes);
  if (progress.should_stop()) return stopped();
  if (auto error = lay_flat(report, *found, request, progress)) return error;
  if (progress.should_stop()) return stopped();
  progress.at("checking", 0.9);
  return inspect(report, found->sheet, request);
}

}  // namespace

Result<UnfoldReport> unfold_body(const Body& body, const UnfoldRequest& request,
                                 const Progress& progress) {
  UnfoldReport report;
  report.body = body.name();
  report.quantity = body.quantity();
  report.units = request.units;
  const auto start = std::chrono::steady_clock::now();
  const auto error = fill(report, body, request, progress);
  report.unfold_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!error) return report;
  if (exit_status(error->code) != kRefusedStatus) return tl::unexpected(*error);
  report.refusal = *error;
  return report;
}

}  // namespace planish::job
