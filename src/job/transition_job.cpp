#include "folded.hpp"
#include "lay_flat.hpp"

#include <planish/job/text_file.hpp>
#include <planish/job/transition.hpp>

#include <fmt/format.h>

#include <chrono>

namespace planish::job {
namespace {

/// Outlines are held to this, because nets are compared with closed forms and with each other (mm).
constexpr double kOutline = 1e-7;

/// What is within this of a line, an arc or a point is one: more than the rounding of a cone's
/// image about its apex (mm).
constexpr double kMerged = 5e-7;

/// Solids are splines within a micrometre anyway: a share of the extent that costs less to write.
constexpr double kFolded = 1e-8;

/// A share of the extent that nobody sees.
constexpr double kDrawn = 1e-7;

TransitionReport begun(const MakeRequest& request, LengthUnit unit) {
  TransitionReport report;
  report.input = request.input.string();
  report.body = request.input == "-" ? "stdin" : request.input.stem().string();
  report.units = request.units.value_or(unit);
  return report;
}

FlattenOptions options_of(const TransitionSpec& spec, const MakeRequest& request) {
  FlattenOptions options;
  options.allowance = ConstantK{spec.k_factor,
                                request.allowance ? "command line" : "transition file"};
  options.curve_tolerance = kOutline;
  options.merge_tolerance = kMerged;
  return options;
}

/// `folded` is what its solid is made of, or why there is none.
std::optional<Error> lay_piece(TransitionPiece& piece, Sheet& sheet,
                               const Result<FoldedPiece>& folded, const TransitionSpec& spec,
                               const MakeRequest& request, const Progress& progress) {
  if (folded) {
    if (auto stopped = fold(piece, sheet, folded->sheet, piece.solid, progress)) return stopped;
    sheet.forms_volume = -folded->cut_area * sheet.thickness;
  } else {
    leave_unfolded(piece, folded.error(), piece.solid);
  }
  piece.sheet = summary_of(sheet);
  return lay_flat(piece, {sheet, border_distance(sheet), request}, options_of(spec, request),
                  progress);
}

std::optional<Error> draw_piece(TransitionPiece& piece, const Sheet& sheet,
                                const TransitionSpec& spec, const MakeRequest& request,
                                const Progress& progress) {
  piece.sheet = summary_of(sheet);
  return lay_flat(piece, {sheet, EdgeDistance(), request}, options_of(spec, request), progress);
}

/// What is said of one piece is said of the whole; of several, their findings are.
void gather(TransitionReport& report) {
  if (report.pieces.size() == 1) {
    static_cast<Report&>(report) = report.pieces.front();
    return;
  }
  for (const TransitionPiece& piece : report.pieces) {
    report.sheet.thickness = piece.sheet.thickness;
    report.sheet.flanges += piece.sheet.flanges;
    report.sheet.bends += piece.sheet.bends;
    report.findings.insert(report.findings.end(), piece.findings.begin(), piece.findings.end());
    if (piece.mass) report.mass = report.mass.value_or(0.0) + *piece.mass;
  }
}

std::optional<Error> fill(TransitionReport& report, const TransitionFile& file,
                          const MakeRequest& request, const Progress& progress) {
  TransitionSpec& spec = report.spec;
  spec = file.spec;
  if (request.allowance) spec.k_factor = std::get<ConstantK>(*request.allowance).k;
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
    piece.body = sheets.size() == 1 ? report.body : fmt::format("{}-{}", report.body, i + 1);
    auto wrong = draft ? draw_piece(piece, sheets[i], spec, request, progress)
                       : lay_piece(piece, sheets[i], folded_piece(i), spec, request, progress);
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

Result<TransitionReport> transition_between(const TransitionFile& file, const MakeRequest& request,
                                            const Progress& progress) {
  TransitionReport report = begun(request, file.units);
  if (const auto error = reported(report, [&] { return fill(report, file, request, progress); }))
    return tl::unexpected(*error);
  return report;
}

Result<TransitionReport> transition(const MakeRequest& request, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const auto text = read_text(request.input, "transition file");
  if (!text) return tl::unexpected(text.error());
  const auto file = parse_transition(*text, place_name(request.input.string()));
  if (!file) return tl::unexpected(file.error());
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  auto report = transition_between(*file, request, progress);
  if (report) report->read_seconds = taken.count();
  return report;
}

TransitionReport failed_transition(const MakeRequest& request, const Error& error) {
  TransitionReport report = begun(request, LengthUnit::mm);
  report.refusal = error;
  return report;
}

}  // namespace planish::job
