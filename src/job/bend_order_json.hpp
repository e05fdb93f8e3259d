#pragma once

#include "json_parts.hpp"

#include <planish/brake/order.hpp>
#include <planish/job/report.hpp>

namespace planish::job {

/// The first keys of an order: what became of it. Of the cheapest one, and of one that was given.
Json planned_order_json(const Plan& plan, const Bending& bending, const Report& report);
Json checked_order_json(const CheckedOrder& checked);

/// The rest: its costs, its strokes and the tools they are made with. Scenes and tools in mm.
void add_order(Json& json, const CheckedOrder& checked, const Report& report,
               const BrakeTools& tools);

}  // namespace planish::job
