#pragma once

#include <planish/job/artifact.hpp>
#include <planish/schema/schema.hpp>

#include <vector>

namespace planish::job {

/// Keys that a maker adds to the common ones: of the report, and of each bend.
struct ReportDetails {
  std::vector<schema::Field> report, bend;
};

/// Schemas of outputs: reports of all makers, the summary of several bodies, `planish info`.
schema::Schema report_schema(const Catalogue& catalogue);
schema::Schema summary_schema(const Catalogue& catalogue);
schema::Schema info_schema();

/// The common keys of reports, from "units" on.
std::vector<schema::Field> common_report_fields();

/// A number, or null if it could not be measured.
schema::Schema measured_number();
schema::Schema measured_length();
schema::Schema measured_area();
/// Points whose coordinates may be null.
schema::Schema report_point();
schema::Schema report_space_point();
schema::Schema report_line();
schema::Schema reason_schema();

}  // namespace planish::job
