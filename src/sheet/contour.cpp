#include "contour.hpp"

#include <planish/geometry/fit.hpp>

#include <algorithm>

namespace planish {
namespace {

/// Borders of the whole sheet in one row, with the border on the other side of a joint.
class BorderTable {
 public:
  explicit BorderTable(const Sheet& sheet) {
    for (size_t f = 0; f < sheet.faces.size(); ++f) {
      offsets_.emplace_back();
      for (size_t l = 0; l < sheet.faces[f].loops.size(); ++l) {
        offsets_.back().push_back(static_cast<int>(rows_.size()));
        const int count = static_cast<int>(sheet.faces[f].loops[l].size());
        for (int i = 0; i < count; ++i)
          rows_.push_back(
              {{FaceId{static_cast<int>(f)}, static_cast<int>(l), i}, count, -1, false});
      }
    }
    for (const Joint& joint : sheet.joints) {
      const int a = row_of(joint.a);
      const int b = row_of(joint.b);
      rows_[a].twin = b;
      rows_[b].twin = a;
      rows_[a].sharp = rows_[b].sharp = joint.sharp.has_value();
    }
  }

  int size() const { return static_cast<int>(rows_.size()); }
  bool free(int row) const { return rows_[row].twin < 0; }
  const BorderRef& ref(int row) const { return rows_[row].ref; }

  /// The free border that follows a free border along the contour.
  struct Step {
    int row;
    bool across_sharp;
  };
  Step next(int row) const {
    Step step{after(row), false};
    for (int guard = 0; !free(step.row) && guard < size(); ++guard) {
      step.across_sharp |= rows_[step.row].sharp;
      step.row = after(rows_[step.row].twin);
    }
    return step;
  }

 private:
  struct Row {
    BorderRef ref;
    int loop_size;
    int twin;
    bool sharp;
  };
  int row_of(const BorderRef& ref) const {
    return offsets_[index_of(ref.face)][ref.loop] + ref.border;
  }
  int after(int row) const {
    const Row& r = rows_[row];
    return r.ref.border + 1 < r.loop_size ? row + 1 : row + 1 - r.loop_size;
  }
  std::vector<Row> rows_;
  std::vector<std::vector<int>> offsets_;
};

/// Contour before recognition: exact images of the borders.
struct RawContour {
  Loop loop;
  std::vector<Origin> origins;
  void add(Curve2 curve, const BorderRef& border, bool gap) {
    origins.push_back({border, gap, curve});
    loop.push_back(std::move(curve));
  }
};

RawContour walk(const UnfoldingTree& tree, const BorderTable& table, int start,
                std::vector<bool>& seen) {
  RawContour contour;
  int row = start;
  do {
    seen[row] = true;
    contour.add(tree.image(table.ref(row)), table.ref(row), false);
    const BorderTable::Step step = table.next(row);
    if (step.across_sharp) {
      const Vec2 from = end_of(contour.loop.back());
      const Vec2 to = start_of(tree.image(table.ref(step.row)));
      contour.add(Segment{from, to}, table.ref(row), true);
    }
    row = step.row;
  } while (row != start && !seen[row]);
  return contour;
}

Contour finished(RawContour raw, double tolerance) {
  Contour contour;
  MergedLoop merged_loop = merged(raw.loop, tolerance);
  const size_t inputs = raw.origins.size();
  const size_t outputs = merged_loop.loop.size();
  contour.origins.resize(outputs);
  for (size_t i = 0; i < outputs; ++i) {
    const size_t first = static_cast<size_t>(merged_loop.first_input[i]);
    const size_t last = static_cast<size_t>(merged_loop.first_input[(i + 1) % outputs]);
    const size_t span = outputs == 1 ? inputs : (last + inputs - first) % inputs;
    for (size_t k = 0; k < span; ++k)
      contour.origins[i].push_back(raw.origins[(first + k) % inputs]);
  }
  contour.loop = std::move(merged_loop.loop);
  return contour;
}

/// The formed feature that a contour outlines, or −1 for a cut.
int feature_of(const Sheet& sheet, const RawContour& contour) {
  for (const Origin& origin : contour.origins)
    if (const int feature = border_at(sheet, origin.border).feature; feature >= 0) return feature;
  return -1;
}

}  // namespace

Result<Contours> chain_contours(const Sheet& sheet, const UnfoldingTree& tree,
                                const FlattenOptions& options) {
  const BorderTable table(sheet);
  std::vector<bool> seen(static_cast<size_t>(table.size()), false);
  Contours contours;
  double outer_area = 0.0;
  for (int row = 0; row < table.size(); ++row) {
    if (seen[row] || !table.free(row)) continue;
    RawContour raw = walk(tree, table, row, seen);
    const double area = signed_area(raw.loop);
    const int feature = feature_of(sheet, raw);
    if (feature >= 0 && area > outer_area) return tl::unexpected(sheet.features[feature].at_rim);
    if (feature >= 0) {
      contours.formed.emplace_back(feature, merged(raw.loop, options.merge_tolerance).loop);
      continue;
    }
    Contour contour = finished(std::move(raw), options.merge_tolerance);
    if (area > outer_area) {
      // What was taken for the outer contour before is an opening whose rim covers itself.
      if (outer_area > 0) contours.openings.push_back(std::move(contours.outer));
      contours.outer = std::move(contour);
      outer_area = area;
    } else {
      contours.openings.push_back(std::move(contour));
    }
  }
  if (outer_area <= 0)
    return fail(ErrorCode::closed_loop,
                "The sheet has no outer contour: its bends close on themselves.");
  return contours;
}

}  // namespace planish
