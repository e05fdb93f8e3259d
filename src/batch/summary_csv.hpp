#pragma once

#include <planish/batch/part_record.hpp>

#include <string>

namespace planish::batch {

/// The table of parts as CSV (RFC 4180), titles first. `same_as` is the folder of the first
/// identical part; empty for the first.
std::string csv_titles();
std::string csv_of(const PartRecord& part, const std::string& same_as);

}  // namespace planish::batch
