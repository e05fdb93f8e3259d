#pragma once

#include <planish/job/report.hpp>
#include <planish/schema/schema.hpp>

#include <string>
#include <vector>

namespace planish::job {

/// "B3: flange 4 hits punch P88 by 3.1 mm at 72°"
Told told_of(const BlockedBend& blocked, const Report& report);

/// "over a V of 10 mm (V10-88, V10-85)": how an infeasible part could be bent.
std::string proposal_sentence(const Proposal& proposal, const Report& report);

/// The same as remedies of what says that it cannot be bent; with the option where there is one.
std::vector<Remedy> remedies_of(const std::vector<Proposal>& proposals, const Report& report);

/// The proposals of a plan with the keys of formats.md#plan.
schema::Json proposals_json(const Plan& plan, const Report& report);
schema::Schema proposal_schema();

/// The same for a terminal; empty without any.
std::string proposals_text(const Plan& plan, const Report& report);

}  // namespace planish::job
