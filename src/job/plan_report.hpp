#pragma once

#include <planish/brake/check_dimensions.hpp>
#include <planish/job/report.hpp>
#include <planish/schema/schema.hpp>
#include <planish/schema/units.hpp>

#include <string>
#include <vector>

namespace planish::job {

/// Whether there is an order without any stroke.
bool nothing_to_bend(const Plan& plan);

/// "F3"
std::string flange_id(FlangeId flange);
/// "B3", as the pattern of a report calls the bend.
std::string bend_id(const Report& report, BendId bend);
std::vector<std::string> bend_ids(const Report& report, const std::vector<BendId>& bends);

/// What to measure after each of the strokes.
std::vector<std::optional<CheckDimension>> checks_of(const Report& report,
                                                     const std::vector<Stroke>& strokes);

/// The plan of a report with the keys of formats.md#plan.
schema::Json plan_json(const Plan& plan, const Report& report);
schema::Schema plan_schema();

/// What it has for one stroke, and for what is in the way of one; the word for its status.
schema::Json stroke_json(const Stroke& stroke, const std::optional<CheckDimension>& check,
                         const Report& report);
schema::Json blocked_json(const BlockedBend& blocked, const Report& report);
std::string_view status_word(const Plan& plan);

/// The same for a terminal.
std::string plan_text(const Plan& plan, const Report& report);

}  // namespace planish::job
