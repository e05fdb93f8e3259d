#pragma once

#include "workpiece.hpp"

#include <planish/base/union_find.hpp>
#include <planish/sheet/topology.hpp>

#include <map>

namespace planish::brake_detail {

inline constexpr double kTouching = 1e-4;  // mm: pieces of a line or a zone that are one

/// Cuts a sheet at its lines.
class Cutting {
 public:
  Cutting(const Sheet& sheet, const Layout& layout, const WorkpieceOptions& options)
      : sheet_(sheet), layout_(layout), options_(options), nodes_(count_nodes()) {}

  Result<Workpiece> cut();

 private:
  /// A line of one bend: bends between the same bodies become one line afterwards.
  struct Raw {
    BrakeLine line;                  // u grows to its left
    std::pair<int, int> nodes;       // on its right and left
    std::vector<Convex> bands = {};  // of a sharp bend: what lies between its joints
    double ruling = 0.0;             // its length, mm
    int number = -1;                 // of the line that it is part of
  };

  int count_nodes();
  const LargeBend* large(BendId bend) const;
  int strokes_of(BendId bend) const;
  int region_of(BendId bend, double u) const;
  int node_at(const BorderRef& ref) const;
  void unite_across(const Joint& joint);
  BrakeLine line_of(BendId id) const;
  std::optional<Error> add_lines(BendId id);
  void add_press_line(BendId id, int number);
  void add_sharp_lines();
  void add_sharp_line(BendId bend, const std::vector<int>& joints);
  bool lies_left(FaceId face) const { return signed_area(layout_.outline(face)) > 0.0; }
  int body_of(int node);
  void number_bodies();
  void number_lines();
  void add_closing_lines();
  std::optional<Error> check_tree() const;
  void add_material();
  void add_bend_material(BendId id, const Convex& piece);
  void add_to_zone(const Raw& raw, const Convex& piece);
  IdVector<BorderId, bool> along_openings(const Topology& topology) const;
  void add_edges();

  const Sheet& sheet_;
  const Layout& layout_;
  WorkpieceOptions options_;
  IdVector<BendId, int> first_region_;
  IdVector<BendId, std::vector<double>> lines_at_;
  UnionFind nodes_;
  std::map<int, int> body_of_root_;
  std::vector<Raw> raw_;
  IdVector<BendId, int> first_raw_;
  Workpiece made_;
};

}  // namespace planish::brake_detail
