#pragma once

#include "line_set.hpp"
#include "workpiece.hpp"

namespace planish::brake_detail {

/// A convex piece of the workpiece at θ = 0, between two rings of corners that belong together:
/// x along the bend line, y the distance from it on its own side, z above the inside skin.
struct Block3 {
  std::vector<Vec3> lower, upper;
};

/// Corners (y, z) of the part of a block with lo ≤ x ≤ hi, convex.
Convex section(const Block3& block, double lo, double hi);
Interval extent(const Block3& block);

/// A part of a zone that is being pressed, between two distances from the bend line.
struct ArcStrip {
  double from = 0.0, to = 0.0;
  bool left = false;
  Interval along;  ///< range of x
};

/// A body of the workpiece, or the zone of a line, where it is in a stage while a line is pressed:
/// rigid blocks, or the strips of a zone that is being pressed.
struct PlacedPart {
  std::vector<ArcStrip> strips;
  std::vector<Block3> blocks;
  std::vector<Convex> sections;                          ///< of each block, whole
  Convex hull;                                           ///< of all sections
  Interval along;                                        ///< range of x
  Eigen::Isometry3d at = Eigen::Isometry3d::Identity();  ///< of a body: from the pattern
  bool left = false;                                     ///< the side it is on
  bool flat = false;  ///< in the plane of the lying sheet: no formed line on the way
};

/// The parts of a workpiece as seen from one of its lines, on both sides of it.
class PartTree {
 public:
  /// A part: the zone of a line, or a body.
  struct Part {
    bool is_zone = false;
    int index = 0;    ///< of the line or the body
    int before = -1;  ///< the body it hangs on, as a part; −1: on the line itself
    int over = -1;    ///< the line between that and this body
    int slot = 0;     ///< its number among what hangs on the same body
    bool left = false;
    LineSet path;            ///< lines on which its place depends
    std::vector<int> lines;  ///< the same
  };

  PartTree(const Workpiece& work, int line);

  int line() const { return line_; }
  const std::vector<Part>& parts() const { return parts_; }
  int part_of_body(int body) const { return part_of_body_[body]; }
  /// Where the pattern of a body lies, in the frame of the line: x along it (turned so that z is
  /// up on the inside skin), y to its left.
  Eigen::Isometry3d place(int part, const LineSet& formed) const;
  /// How many parts hang on a body.
  int hanging(int part) const { return hanging_[part]; }
  /// The zone of the tree's line, a hem, when it is closed and its right side lies.
  std::vector<Block3> closed_zone() const;
  /// How a line is in a stage.
  enum class State { flat, formed, closed, pressed };
  static constexpr size_t kStates = 4;
  State state(int line, const LineSet& formed, const LineSet& pressed) const;
  /// The part, from the body it hangs on (null: on the line itself) and how the line between is.
  PlacedPart placed(int part, const PlacedPart* before, State over) const;

 private:
  void grow();
  Eigen::Isometry3d step(const Part& part, Angle angle) const;
  void add_body(const Part& part, PlacedPart& placed) const;
  void add_zone(const Part& part, const Eigen::Isometry3d& before, State state,
                PlacedPart& placed) const;
  void add_strips(const Part& part, const Eigen::Isometry3d& before, PlacedPart& placed) const;
  template <typename Take>
  void cut_zone(const Part& part, const Eigen::Isometry3d& before, State state, int count,
                const Take& take) const;

  const Workpiece& work_;
  int line_;
  std::vector<Part> parts_;
  std::vector<int> part_of_body_;
  std::vector<int> hanging_;
  std::vector<Eigen::Isometry3d> steps_, closed_steps_;  ///< by part: what a formed line does to
                                                         ///< a body, and a closed hem
};

/// Fills in what follows from the blocks.
void summarise(PlacedPart& part);

/// From the pattern (z = 0 in the middle of the sheet) to the frame of a line.
Eigen::Isometry3d line_frame(const BrakeLine& line);

/// The left side of a line that is bent by an angle, in the frame of the line; the right side
/// stays.
Eigen::Isometry3d bent_side(const BrakeLine& line, Angle angle);

}  // namespace planish::brake_detail
