#pragma once

#include "stroke_inputs.hpp"

#include <planish/brake/order.hpp>

namespace planish::brake_detail {

/// A sheet made ready for strokes. The tools must outlive what is returned. Errors: those of
/// `plan_bending`, except `cancelled`.
Result<StrokeInputs> prepared(const Sheet& sheet, const Layout& layout, const BrakeTools& tools,
                              const PlanOptions& options);

/// The lines that a stroke presses.
LineSet lines_of(const Workpiece& work, const OrderedStroke& stroke);

/// "B3"
std::string name_of(BendId bend);

/// The first line that no tool bears: `no_tool`.
std::optional<Error> line_without_tool(const StrokeInputs& inputs);

}  // namespace planish::brake_detail
