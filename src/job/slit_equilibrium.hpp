#pragma once

#include <planish/inspect/findings.hpp>
#include <planish/job/slit.hpp>
#include <planish/schema/json_parts.hpp>
#include <planish/schema/schema.hpp>

#include <string>
#include <vector>

namespace planish::job {

/// What weight and loads do to a sheet of a material, in reports (formats.md#slit-report). Nothing
/// without a material.
std::vector<schema::Field> equilibrium_fields();
std::vector<schema::Field> strip_equilibrium_fields();
void add_equilibrium(schema::Json& slit, const SlitReport& report, const schema::Units& units);
std::string equilibrium_text(const SlitReport& report);

/// Findings `yields`, `springs_open`, `unstable`, `falls_over`. `at`: a place of each strip in the
/// pattern.
std::vector<Finding> equilibrium_findings(const SlitReport& report, const std::vector<Vec2>& at);

}  // namespace planish::job
