#pragma once

#include "obstruction.hpp"
#include "stage_cache.hpp"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace planish::brake_detail {

/// A stroke as it was chosen, in its stage.
struct ChosenStroke {
  LineSet formed;
  StrokeChoice choice;
  bool blocked = false;  ///< it cannot be made, and stands nowhere
};

using Rows = std::array<std::vector<ToolRow>, 2>;  ///< of the punch, of the die

/// What a stroke asks of a station, as the operator sees it: x from the left end of its line.
struct Demand {
  int stroke = 0;
  StrokeChoice choice = {};
  std::vector<Interval> pieces = {};                ///< of the line
  std::array<std::vector<Interval>, 2> walls = {};  ///< where punch and die may not stand
  std::vector<Interval> foot_walls = {};            ///< where not even the foot of an ear may
  Interval part = {};                               ///< of the workpiece
  Interval line = {};                               ///< in the frame of the line
  bool from_left = true;                            ///< its x runs as the operator's
};
Demand demand_of(StageCache& cache, const ChosenStroke& chosen, int number);

/// A station while its set-up grows. x from the line of its first stroke.
struct StationTools {
  int punch = 0, die = 0;
  Rows rows = {};
  Interval tools = {}, reach = {};  ///< of the rows; with the workpieces
  struct Made {
    std::shared_ptr<const Demand> demand;
    double at = 0.0;  ///< the left end of its line
  };
  std::vector<Made> strokes = {};

  int first_stroke() const;

  /// Whether the rows press the line of a stroke from there and are clear `by` of what is beside
  /// it.
  bool stands(const Demand& demand, double shortfall, double at, double by = 0.0) const;
  /// Where the line of a stroke may begin: in the middle of the rows if that is clear, else in the
  /// middle between the places where one or the other end just does.
  std::optional<double> where(const Demand& demand, double shortfall) const;
  void add(std::shared_ptr<const Demand> demand, double at);
  /// Stands punches of their own for a stroke, given along its line, over the die beside those that
  /// are there, as near as all strokes allow; the die is moved along under them. Whether that can
  /// be: if not, nothing is changed.
  bool stand_beside(const std::vector<ToolRow>& punches, std::shared_ptr<const Demand> demand,
                    double shortfall);
  /// Sets `tools` and `reach` by the rows and strokes.
  void fit_ends();
};

}  // namespace planish::brake_detail
