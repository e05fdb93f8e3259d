#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/slit/equilibrium.hpp>
#include <planish/slit/folded_slit_sheet.hpp>
#include <planish/slit/slit_sheet.hpp>

#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace planish {

/// How far one call of `solve` goes. Call it again to continue.
struct SlitSolveOptions {
  int max_iterations = 200;  ///< for each strip
  double seconds = std::numeric_limits<double>::infinity();
  /// A strip is done when an iteration gains less than this share of its objective.
  double function_tolerance = 1e-7;
};

/// The state of a strip. `open`: changed, and not fully solved since. `solved`: the constraints are
/// met and the objective is at a minimum. `out_of_reach`: no folding was found that meets the
/// constraints; the shape comes nearest, and `shortfall` says how near.
enum class StripStatus { open, solved, out_of_reach };

struct StripState {
  StripStatus status = StripStatus::open;
  double gap = 0.0;  ///< largest distance of its end from where it must be, mm
  /// The gap of a strip out of reach, else 0. 0 for a strip out of reach: its end is in place, but
  /// points backwards.
  double shortfall = 0.0;
  /// Smallest radius of the mid-surface, mm: of arcs that touch neighbouring quads, using half of
  /// each. Infinite for a flat strip.
  double min_radius = 0.0;
  int tightest_ridge = 0;
  bool too_tight = false;    ///< min_radius could not be kept above what the material allows
  std::vector<int> crosses;  ///< strips of higher number that it crosses
  /// Energy of the next best shape of those that were tried at first, roughly; empty if there was
  /// no other, or smoothness is wanted.
  std::optional<double> runner_up_energy = {};
  double below_ground = 0.0;   ///< how deep its middle surface goes below where it must stay, mm
  bool crosses_plane = false;  ///< runs through the symmetry plane, and so through its mirror image
  double objective = 0.0;
  double energy = 0.0;         ///< of bending, N mm, for a flexural rigidity D of 1 N mm
  double seat_distance = 0.0;  ///< largest distance of the end's corners from the seat curve, mm; 0
                               ///< without one
  double anchor_distance = 0.0;  ///< largest distance from its anchors, mm
  double scan_distance = 0.0;    ///< root mean square distance of the ridges' ends from the scanned
                                 ///< surface, mm
  int iterations = 0;            ///< in the last call that solved it
};

struct SlitSolveReport {
  bool converged = true;  ///< no strip is left open
  int strips_solved = 0;  ///< worked on in this call
  int iterations = 0;     ///< of all of them
  double seconds = 0.0;
  double gap = 0.0;  ///< largest of all strips, mm
};

/// A slit sheet being designed. A new design marks the strips that it affects; `solve` works on
/// these only, starting from their present shape. End conditions are constraints: every shape
/// between two iterations meets them to 1e-12 of the strip's length. Not thread-safe; different
/// sessions are. `where` of an error is the JSON pointer of its cause in a slit file
/// (formats.md#slits).
class SlitSession {
 public:
  /// Errors (exit status 3): `invalid_input` (numbers not finite or outside their range, weights
  /// negative, curves of less than two poles, a leg curve that meets the symmetry plane),
  /// `unknown_strip`, `unknown_ridge`, `bad_option` (an end placed in a symmetric sheet),
  /// `empty_scan`, `scan_too_large` (over 2 million points a strip). Errors (exit status 4):
  /// `curve_too_short` and `curve_too_long` (the leg curve by more than 2 % of the sheet's width,
  /// measured by chords of the strips' widths stepped along it; within 2 % the curve is continued
  /// straight, or its rest is unused; `fit` scales it; a seat curve shorter than the strips are
  /// wide, which `fit_seat` scales), `radius_too_small` (the leg curve is tighter than the material
  /// allows), `out_of_reach` (an anchor, an end or the second panel farther away than the strip is
  /// long).
  static Result<SlitSession> start(SlitDesign design);

  SlitSession(SlitSession&&) noexcept;
  SlitSession& operator=(SlitSession&&) noexcept;
  ~SlitSession();

  /// Takes a whole design; strips that it does not affect stay as they are. Ridges and anchors may
  /// be numbered as before the subdivisions. A different sheet or number of ridges restarts from
  /// first shapes. The design's scans replace all earlier ones. Errors: those of `start`; the
  /// session is then unchanged.
  Result<void> set_design(SlitDesign design);
  /// Moves all scans by the rigid motion that brings them nearest to the present strips (ICP), and
  /// returns that motion. Error: `empty_scan` (there are no scans).
  Result<Eigen::Isometry3d> align_scans();
  /// Adds a ridge without a fold in the middle of each quad (math.md#subdivision): the shape is
  /// unchanged. Ridge i of anchors becomes 2i.
  void subdivide();

  /// Works on the open strips. Error: `cancelled` (strips worked on so far keep their progress).
  Result<SlitSolveReport> solve(const SlitSolveOptions& options = {},
                                const Progress& progress = {});

  /// The design as set, with its leg curves as scaled, with `ridges` as subdivided and `ends` for
  /// every strip, but without the scans' points (see `scan`).
  const SlitDesign& design() const;
  const std::vector<Vec3>& scan(int strip) const;
  int strip_count() const;
  const StripState& state(int strip) const;
  /// The sheet as folded now.
  FoldedSlitSheet folded() const;
  /// What it bears as folded now; empty without a material.
  std::optional<SlitEquilibrium> equilibrium() const;

 private:
  struct Content;
  explicit SlitSession(std::unique_ptr<Content> content);
  std::unique_ptr<Content> content_;
};

inline constexpr int kMostSubdivisions = 6;
/// A design solved coarse to fine: subdivided and solved again `subdivisions` times (0 to 6).
/// Errors: `bad_option`, those of `SlitSession::start` and `solve`.
Result<SlitSession> solved_slit_sheet(SlitDesign design, int subdivisions,
                                      const SlitSolveOptions& options = {},
                                      const Progress& progress = {});

}  // namespace planish
