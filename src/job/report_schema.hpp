#pragma once

#include "schema.hpp"

#include <planish/job/artifact.hpp>

#include <vector>

namespace planish::job {

/// What a maker's reports have beyond those of all: keys of the report, and of each bend.
struct ReportDetails {
  std::vector<Field> report, bend;
};
ReportDetails unfold_report_details();
ReportDetails connect_report_details();
ReportDetails transition_report_details();
ReportDetails slit_report_details();

/// What is written: reports of all makers, the summary of several bodies, what `planish info` says.
Schema report_schema(const Catalogue& catalogue);
Schema summary_schema(const Catalogue& catalogue);
Schema info_schema();

/// The keys that reports share, from "units" on.
std::vector<Field> common_report_fields();

/// A number that is null where it could not be measured.
Schema measured_number();
Schema measured_length();
Schema measured_area();
/// Points whose coordinates may be null.
Schema report_point();
Schema report_space_point();
Schema report_line();
Schema reason_schema();

}  // namespace planish::job
