#pragma once

#include <planish/brake/order.hpp>
#include <planish/job/report.hpp>
#include <planish/schema/json_parts.hpp>

namespace planish::job {

/// The first keys of an order: what became of it. Of the cheapest one, and of one that was given.
schema::Json planned_order_json(const Plan& plan, const Bending& bending, const Report& report);
schema::Json checked_order_json(const CheckedOrder& checked);

/// The rest: its costs, its strokes and the tools they are made with. Scenes and tools in mm.
void add_order(schema::Json& json, const CheckedOrder& checked, const Report& report,
               const BrakeTools& tools);

}  // namespace planish::job
