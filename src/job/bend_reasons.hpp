#pragma once

#include <planish/io/pages.hpp>
#include <planish/job/report.hpp>

#include <vector>

namespace planish::job {

/// What keeps the part of a report from being bent; empty if it can be.
std::vector<BlockedBend> obstacles_of(const Report& report);

/// Writes on a page why the part cannot be bent, and how it could be, as far down as `bottom`.
void write_reasons(Page& page, const Report& report, const Vec2& from, double bottom);

}  // namespace planish::job
