#pragma once

#include "stroke_model.hpp"

#include <planish/brake/order.hpp>

#include <memory>

namespace planish::brake_detail {

/// A sheet made ready for strokes. The tools must outlive the model. Errors: those of
/// `plan_bending`, except `cancelled`.
Result<std::unique_ptr<StrokeModel>> stroke_model(const Sheet& sheet, const Layout& layout,
                                                  const BrakeTools& tools,
                                                  const PlanOptions& options);

/// The lines that a stroke presses.
LineSet lines_of(const Workpiece& work, const OrderedStroke& stroke);

/// "B3"
std::string name_of(BendId bend);

/// The first line that no tool bears: `no_tool`.
std::optional<Error> line_without_tool(const StrokeModel& model);

}  // namespace planish::brake_detail
