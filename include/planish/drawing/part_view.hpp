#pragma once

#include <planish/base/result.hpp>
#include <planish/geometry/frame.hpp>
#include <planish/sheet/layout.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace planish::drawing {

/// A folded part as lines on paper, hidden ones left out: mm of the part, y up.
struct PartView {
  std::vector<std::vector<Vec2>> edges;  ///< polylines
  std::vector<std::vector<Vec2>> bends;  ///< where flanges and bends meet
};

/// The isometric view of a sheet, the side that its layout shows up. What hides a line is found on
/// a raster of `cells` along the longer side, so ends may be off by one; sheets thinner than three
/// cells are drawn without thickness. O(cells² + edges · length). Requires the layout of that
/// sheet.
PartView isometric_view(const Sheet& sheet, const Layout& layout, int cells = 800);

/// A view as one line of JSON, to a hundredth of a millimetre, and back. Error: `invalid_input` for
/// text that is not one.
std::string view_json(const PartView& view);
Result<PartView> read_view_json(std::string_view text);

}  // namespace planish::drawing
