#include "folded.hpp"
#include "from_file.hpp"
#include "lay_flat.hpp"
#include "made_report.hpp"
#include "refusals.hpp"
#include "sentences.hpp"
#include "taken_shop.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/brake/codes.hpp>
#include <planish/job/transition.hpp>

#include <fmt/format.h>

#include <algorithm>

// A transition to its report, piece by piece. The folded solid comes from sheets of its own, with
// tips cut off and the seam open (transition.md#output), so where it fails the net is still
// written. Tolerances follow the use: nets are compared with closed forms, solids written to a
// micrometre, drafts only seen.

namespace planish::job {
using namespace shop;
namespace {

/// Of outlines (mm).
constexpr double kNetOutline = 1e-7;

/// A curve within this of a line, an arc or a point becomes one (mm); more than the rounding of a
/// cone's image near its apex.
constexpr double kMerged = 5e-7;

/// Of solids, a share of the extent.
constexpr double kFolded = 1e-8;

/// A share of the extent too small to see.
constexpr double kDrawn = tolerance::kFileDigits;

/// K of all bends, and who says so.
Result<ConstantK> k_of(const TransitionFile& file, const Request& request) {
  const TransitionSpec& spec = file.spec;
  if (request.allowance) {
    const auto* constant = std::get_if<ConstantK>(&*request.allowance);
    if (constant) return ConstantK{constant->k, "constant"};
    const char* option = std::holds_alternative<MaterialCurves>(*request.allowance) ? "material"
                         : std::holds_alternative<BendTable>(*request.allowance)    ? "k_table"
                                                                                    : "din6935";
    return fail(refuse::k_of_transition, {{"option", option}}, option);
  }
  if (request.shop && gauge_of(*request.shop, spec.thickness))
    return shop_k(*request.shop, spec.thickness);
  return ConstantK{spec.k_factor, file.has_default_k ? "default" : "transition file"};
}

FlattenOptions options_of(const ConstantK& k) {
  FlattenOptions options;
  options.allowance = k;
  options.curve_tolerance = kNetOutline;
  options.merge_tolerance = kMerged;
  return options;
}

/// `folded` is the piece to make its solid from, or why there is none.
std::optional<Error> lay_piece(TransitionPiece& piece, Sheet& sheet,
                               const Result<FoldedPiece>& folded, const FlattenOptions& options,
                               const Request& request, const Progress& progress) {
  std::optional<FoldedBody> body;
  if (folded) {
    if (auto stopped = fold(piece, sheet, folded->sheet, piece.solid, progress)) return stopped;
    if (piece.solid) {
      body.emplace(
          FoldedBody{*piece.solid, folded->sheet, {folded->seams.begin(), folded->seams.end()}});
      if (folded->ridge) body->seams.push_back(*folded->ridge);
    }
    sheet.forms_volume = -folded->cut_area * sheet.thickness;
  } else {
    leave_unfolded(piece, folded.error(), piece.solid);
  }
  piece.summary = summary_of(sheet);
  return lay_flat(piece, {sheet, border_distance(sheet), request, body}, options, progress);
}

std::optional<Error> draw_piece(TransitionPiece& piece, const Sheet& sheet,
                                const FlattenOptions& options, const Request& request,
                                const Progress& progress) {
  piece.summary = summary_of(sheet);
  return lay_flat(piece, {sheet, EdgeDistance(), request}, options, progress);
}

/// What closes round the punch cannot be bent in one piece, and mostly in two.
void advise_halves(TransitionPiece& piece, std::optional<Error>& wrong) {
  const auto advise = [](std::string& message, std::vector<Remedy>& remedies) {
    message += say::halves;
    remedies.push_back({.change = "\"pieces\": 2"});
  };
  for (Finding& finding : piece.findings)
    if (finding.code == code::cannot_bend.name) advise(finding.message, finding.remedies);
  if (!wrong || wrong->code != code::cannot_bend) return;
  if (wrong->message.ends_with('.')) wrong->message.pop_back();
  advise(wrong->message, wrong->remedies);
  wrong->message += '.';
}

/// The report of a single piece becomes the whole's; of several pieces, only the findings.
void gather(TransitionReport& report) {
  std::ranges::for_each(report.pieces, say_in_its_units);
  if (report.pieces.size() == 1) {
    static_cast<Report&>(report) = report.pieces.front();
    return;
  }
  for (const TransitionPiece& piece : report.pieces) {
    report.summary.thickness = piece.summary.thickness;
    report.summary.flanges += piece.summary.flanges;
    report.summary.bends += piece.summary.bends;
    report.findings.insert(report.findings.end(), piece.findings.begin(), piece.findings.end());
    if (piece.mass) report.mass = report.mass.value_or(0.0) + *piece.mass;
  }
}

std::optional<Error> fill(TransitionReport& report, const TransitionFile& file,
                          const Request& request, const Progress& progress) {
  TransitionSpec& spec = report.spec;
  spec = file.spec;
  const auto k = k_of(file, request);
  if (!k) return k.error();
  spec.k_factor = k->k;
  const FlattenOptions options = options_of(*k);
  progress.at("finding the surface", 0.0);
  const bool draft = request.effort == Effort::draft;
  auto made = make_transition(spec, {.tolerance = draft ? kDrawn : TransitionOptions{}.tolerance},
                              progress);
  if (!made) return placed(made.error(), place_name(report.input));
  report.transition = std::move(*made);
  const auto folded = draft ? Result<std::vector<FoldedPiece>>()
                            : folded_pieces(spec, {.tolerance = kFolded});
  const auto folded_piece = [&](std::size_t i) -> Result<FoldedPiece> {
    if (!folded) return tl::unexpected(placed(folded.error(), place_name(report.input)));
    return (*folded)[i];
  };
  auto& sheets = report.transition.pieces;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    TransitionPiece piece;
    piece.input = report.input;
    piece.units = report.units;
    piece.material = report.material;
    piece.quantity = report.quantity;
    piece.body = sheets.size() == 1 ? report.body : fmt::format("{}-{}", report.body, i + 1);
    auto wrong = draft ? draw_piece(piece, sheets[i], options, request, progress)
                       : lay_piece(piece, sheets[i], folded_piece(i), options, request, progress);
    if (sheets.size() == 1) advise_halves(piece, wrong);
    report.pieces.push_back(std::move(piece));
    if (wrong) {
      gather(report);
      return wrong;
    }
  }
  gather(report);
  return std::nullopt;
}

}  // namespace

Outcome<TransitionReport> transition_between(const TransitionFile& file, const Request& request,
                                             const Progress& progress) {
  return reported(begun<TransitionReport>(request, file.units), [&](TransitionReport& report) {
    const auto mine = request_of_part(request, report);
    return mine ? fill(report, file, *mine, progress) : mine.error();
  });
}

Outcome<TransitionReport> transition(const Request& request, const Progress& progress) {
  const auto parse = [](const InputFile& input) {
    return parse_transition(input.content, input.name);
  };
  return from_file(request, "transition file", parse, transition_between, progress);
}

}  // namespace planish::job
