#include "refusals.hpp"

#include <planish/drawing/part_view.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/sheet/facets.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

// The folded part as an isometric drawing without hidden lines. Its plane pieces (both skins and
// the walls between, or the middle alone where the thickness is under three cells) are filled into
// a raster of depths. A line is then shown step by step where the raster has nothing nearer. So the
// time follows the cells and the lines, not pairs of faces, and an end of a line may be off by a
// cell.

namespace planish::drawing {
namespace {

/// From space to the paper: to the right, up, towards the viewer.
Eigen::Matrix3d isometric() {
  Eigen::Matrix3d axes;
  axes.row(0) = Vec3(1, -1, 0).normalized();
  axes.row(1) = Vec3(1, 1, 2).normalized();
  axes.row(2) = Vec3(-1, -1, 1).normalized();
  return axes;
}

/// A plane piece in space: corners given by two coordinates.
struct Patch {
  Vec3 origin, u, v;
  std::vector<std::vector<Vec2>> rings;
  Vec3 at(const Vec2& p) const { return origin + p.x() * u + p.y() * v; }
};

/// A line to be drawn where nothing is before it.
struct Edge {
  Vec3 a, b;
  bool bend = false;
};

/// How near the nearest material is to the viewer, cell by cell.
class Raster {
 public:
  Raster(const Box2& box, int cells)
      : low_(box.lo), cell_(std::max(box.size().maxCoeff() / cells, kSmallestCell)) {
    const Vec2 size = box.size() / cell_;
    width_ = static_cast<int>(size.x()) + 1;
    height_ = static_cast<int>(size.y()) + 1;
    near_.setConstant(width_, height_, -std::numeric_limits<double>::infinity());
  }

  double cell() const { return cell_; }

  /// Fills the patch, by the even-odd rule.
  void fill(const Patch& patch) {
    Eigen::Matrix2d to_paper;
    to_paper << patch.u.head<2>(), patch.v.head<2>();
    const double turned = to_paper.determinant();
    if (std::abs(turned) < kEdgeOn * patch.u.norm() * patch.v.norm()) return;
    const Eigen::Matrix2d back = to_paper.inverse();
    const Vec2 slope(back.col(0).dot(Vec2(patch.u.z(), patch.v.z())),
                     back.col(1).dot(Vec2(patch.u.z(), patch.v.z())));
    std::map<int, std::vector<double>> crossed;
    for (const auto& ring : patch.rings)
      for (const auto& [a, b] : sides_of(ring))
        cross(crossed, in_cells(patch.at(a)), in_cells(patch.at(b)));
    for (auto& [row, xs] : crossed) {
      std::ranges::sort(xs);
      for (std::size_t i = 0; i + 1 < xs.size(); i += 2)
        for (int x = first_in(xs[i]); x <= first_in(xs[i + 1]) - 1; ++x) {
          const Vec2 paper = low_ + cell_ * Vec2(x + 0.5, row + 0.5);
          put(x, row, patch.origin.z() + slope.dot(paper - patch.origin.head<2>()));
        }
    }
  }

  /// Whether nothing hides a point.
  bool shows(const Vec3& p) const {
    const Vec2 at = in_cells(p);
    const int x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
    // Beside an outline one of the cells around it is free.
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (near(x + dx, y + dy) <= p.z() + kBehind * cell_) return true;
    return false;
  }

 private:
  static constexpr double kSmallestCell = 1e-6;  // mm
  static constexpr double kEdgeOn = 1e-6;        // sine
  static constexpr double kBehind = 1.5;         // cells: what a sloping face rises in one

  Vec2 in_cells(const Vec3& p) const { return (p.head<2>() - low_) / cell_; }
  /// The first cell whose middle is right of x.
  int first_in(double x) const {
    return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(width_)));
  }

  void cross(std::map<int, std::vector<double>>& crossed, const Vec2& a, const Vec2& b) const {
    const auto [low, high] = std::minmax(a.y(), b.y());
    const int from = std::max(0, static_cast<int>(std::ceil(low - 0.5)));
    const int to = std::min(height_, static_cast<int>(std::ceil(high - 0.5)));
    for (int row = from; row < to; ++row)
      crossed[row].push_back(a.x() + (row + 0.5 - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }

  void put(int x, int y, double depth) { near_(x, y) = std::max(near_(x, y), depth); }
  double near(int x, int y) const {
    if (x < 0 || y < 0 || x >= width_ || y >= height_)
      return -std::numeric_limits<double>::infinity();
    return near_(x, y);
  }

  Vec2 low_;
  double cell_;
  int width_ = 0, height_ = 0;
  Eigen::ArrayXXd near_;  ///< by column and row of the raster
};

/// The folded sheet as plane pieces and the lines between them.
struct Model {
  std::vector<Patch> patches;
  std::vector<Edge> edges;
};

/// One skin, `height` above the middle of the material.
void add_skin(Model& model, const Facets& facets, const std::vector<Eigen::Isometry3d>& motions,
              double height) {
  const auto in_space = [&](int facet, const Vec2& p) {
    return Vec3(motions[static_cast<std::size_t>(facet)] * Vec3(p.x(), p.y(), height));
  };
  for (std::size_t f = 0; f < facets.facets.size(); ++f) {
    const Facet& facet = facets.facets[f];
    const auto& axes = motions[f].linear();
    for (const Polygon& polygon : facet.polygons) {
      Patch patch{
          in_space(static_cast<int>(f), Vec2::Zero()), axes.col(0), axes.col(1), {polygon.outer}};
      patch.rings.insert(patch.rings.end(), polygon.holes.begin(), polygon.holes.end());
      model.patches.push_back(std::move(patch));
    }
    if (!facet.parent || facets.facets[static_cast<std::size_t>(*facet.parent)].part == facet.part)
      continue;
    model.edges.push_back({in_space(static_cast<int>(f), facet.hinge.a),
                           in_space(static_cast<int>(f), facet.hinge.b), true});
  }
  for (const FacetEdge& edge : facets.edges)
    model.edges.push_back({in_space(edge.facet, edge.line.a), in_space(edge.facet, edge.line.b)});
}

/// Where the outline turns: at corners, not where a line runs on into an arc.
class Corners {
 public:
  explicit Corners(const Facets& facets) {
    for (const FacetEdge& edge : facets.edges)
      arriving_[key_of(edge.line.b)] = (edge.line.b - edge.line.a).normalized();
  }

  bool turns_at_start_of(const Segment& line) const {
    constexpr double kSmooth = 0.97;  // cosine: chords of an arc turn by up to 13° or so
    const auto found = arriving_.find(key_of(line.a));
    return found == arriving_.end() || found->second.dot((line.b - line.a).normalized()) < kSmooth;
  }

 private:
  static std::pair<long long, long long> key_of(const Vec2& p) {
    constexpr double kTenthsOfMicrometres = 1e4;
    return {std::llround(p.x() * kTenthsOfMicrometres), std::llround(p.y() * kTenthsOfMicrometres)};
  }
  std::map<std::pair<long long, long long>, Vec2> arriving_;
};

/// The walls between the skins at what is cut, and their corners.
void add_walls(Model& model, const Facets& facets, const std::vector<Eigen::Isometry3d>& motions,
               double thickness) {
  const Corners corners(facets);
  for (const FacetEdge& edge : facets.edges) {
    if (facets.borders[static_cast<std::size_t>(edge.border)].feature) continue;
    const auto& motion = motions[static_cast<std::size_t>(edge.facet)];
    const Vec3 up = thickness * motion.linear().col(2);
    const Vec3 a = motion * Vec3(edge.line.a.x(), edge.line.a.y(), -0.5 * thickness);
    const Vec3 b = motion * Vec3(edge.line.b.x(), edge.line.b.y(), -0.5 * thickness);
    model.patches.push_back({a, b - a, up, {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}});
    if (corners.turns_at_start_of(edge.line)) model.edges.push_back({a, a + up});
  }
}

/// Lines that go on from one another in one.
class Polylines {
 public:
  void add(const Vec2& a, const Vec2& b) {
    constexpr double kSamePoint = 1e-6;  // mm
    if (!lines_.empty() && (lines_.back().back() - a).norm() <= kSamePoint)
      lines_.back().push_back(b);
    else
      lines_.push_back({a, b});
  }
  std::vector<std::vector<Vec2>> take() && { return std::move(lines_); }

 private:
  std::vector<std::vector<Vec2>> lines_;
};

/// Adds what of a line nothing hides.
void add_shown(Polylines& lines, const Raster& raster, const Edge& edge) {
  const Vec2 along = (edge.b - edge.a).head<2>();
  const int steps = std::max(1, static_cast<int>(std::ceil(along.norm() / raster.cell())));
  const auto at = [&](int i) { return Vec3(edge.a + (edge.b - edge.a) * i / steps); };
  int from = -1;
  for (int i = 0; i <= steps; ++i) {
    // The middles of steps decide: ends are on other lines too.
    const bool shown = i < steps && raster.shows(edge.a + (edge.b - edge.a) * (i + 0.5) / steps);
    if (shown && from < 0) from = i;
    if (shown || from < 0) continue;
    constexpr int kShortest = 2;  // steps of a line cut at both ends: crumbs of what is hidden
    if (i - from > kShortest || (from == 0 && i == steps))
      lines.add(at(from).head<2>(), at(i).head<2>());
    from = -1;
  }
}

Model model_of(const Sheet& sheet, const Layout& layout, int cells) {
  const double extent = [&] {
    Box2 box;
    for (const FaceId face : sheet.faces.ids())
      box.add(bounds(layout.outline(face)));
    return box.empty() ? 1.0 : box.size().norm();
  }();
  const Facets facets = facets_of(sheet, layout,
                                  {.chord = extent / cells, .most = Angle::degrees(15.0)});
  std::vector<Eigen::Isometry3d> motions = folded(facets);
  const Eigen::Isometry3d to_pattern = facets.root.inverse();
  for (Eigen::Isometry3d& motion : motions)
    motion = to_pattern * motion;
  constexpr double kDrawnThick = 3.0;  // cells
  Model model;
  if (sheet.thickness < kDrawnThick * extent / cells) {
    add_skin(model, facets, motions, 0.0);
    return model;
  }
  add_skin(model, facets, motions, 0.5 * sheet.thickness);
  add_skin(model, facets, motions, -0.5 * sheet.thickness);
  add_walls(model, facets, motions, sheet.thickness);
  return model;
}

using ViewJson = nlohmann::ordered_json;

ViewJson lines_json(const std::vector<std::vector<Vec2>>& lines) {
  const auto rounded = [](double x) { return std::round(100.0 * x) / 100.0; };
  ViewJson json = ViewJson::array();
  for (const auto& line : lines) {
    ViewJson row = ViewJson::array();
    for (const Vec2& p : line) {
      row.push_back(rounded(p.x()));
      row.push_back(rounded(p.y()));
    }
    json.push_back(std::move(row));
  }
  return json;
}

std::vector<std::vector<Vec2>> lines_in(const ViewJson& json) {
  std::vector<std::vector<Vec2>> lines;
  for (const ViewJson& row : json) {
    const auto numbers = row.get<std::vector<double>>();
    auto& line = lines.emplace_back();
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
      line.emplace_back(numbers[i], numbers[i + 1]);
  }
  return lines;
}

}  // namespace

PartView isometric_view(const Sheet& sheet, const Layout& layout, int cells) {
  Model model = model_of(sheet, layout, cells);
  const Eigen::Matrix3d paper = isometric();
  for (Patch& patch : model.patches)
    for (Vec3* vector : {&patch.origin, &patch.u, &patch.v})
      *vector = paper * *vector;
  Box2 box;
  for (Edge& edge : model.edges)
    for (Vec3* end : {&edge.a, &edge.b}) {
      *end = paper * *end;
      box.add(end->head<2>());
    }
  if (box.empty()) return {};
  Raster raster(box, cells);
  for (const Patch& patch : model.patches)
    raster.fill(patch);
  Polylines edges, bends;
  for (const Edge& edge : model.edges)
    add_shown(edge.bend ? bends : edges, raster, edge);
  return {std::move(edges).take(), std::move(bends).take()};
}

std::string view_json(const PartView& view) {
  return ViewJson{{"format", "planish/view"},
                  {"version", 1},
                  {"edges", lines_json(view.edges)},
                  {"bends", lines_json(view.bends)}}
      .dump();
}

Result<PartView> read_view_json(std::string_view text) {
  const ViewJson json = ViewJson::parse(text, nullptr, false);
  try {
    if (json.at("format") == "planish/view" && json.at("version") == 1)
      return PartView{lines_in(json.at("edges")), lines_in(json.at("bends"))};
  } catch (const ViewJson::exception&) {
  }
  return fail(refuse::view_damaged);
}

}  // namespace planish::drawing
