#pragma once

#include "schema.hpp"

#include <planish/job/artifact.hpp>

#include <vector>

namespace planish::job {

/// Keys that a maker adds to the common ones: of the report, and of each bend.
struct ReportDetails {
  std::vector<Field> report, bend;
};
ReportDetails unfold_report_details();
ReportDetails connect_report_details();
ReportDetails transition_report_details();
ReportDetails slit_report_details();

/// Schemas of outputs: reports of all makers, the summary of several bodies, `planish info`.
Schema report_schema(const Catalogue& catalogue);
Schema summary_schema(const Catalogue& catalogue);
Schema info_schema();

/// The common keys of reports, from "units" on.
std::vector<Field> common_report_fields();

/// A number, or null if it could not be measured.
Schema measured_number();
Schema measured_length();
Schema measured_area();
/// Points whose coordinates may be null.
Schema report_point();
Schema report_space_point();
Schema report_line();
Schema reason_schema();

}  // namespace planish::job
