#pragma once

#include <planish/job/report.hpp>
#include <planish/schema/schema.hpp>

#include <string>
#include <vector>

/// Tools on the bed: rows of segments, and the stations of a plan (math.md#stations).
namespace planish::job {

struct RowKeys {
  const char *from, *segments, *ears, *rows;
};
inline constexpr RowKeys kDieRows{"die_from", "die_segments", "", "die_rows"};

/// All segments of a tool in one row, and where it begins; the rows where there are several.
void add_rows(schema::Json& json, const RowKeys& keys, const std::vector<SegmentRow>& rows,
              const schema::Units& units);
schema::Schema rows_schema();
schema::Schema ears_schema();

schema::Json stations_json(const std::vector<Station>& stations, const Report& report);
schema::Schema station_schema();
/// A table; empty without stations.
std::string stations_text(const Plan& plan, const schema::Units& units);

}  // namespace planish::job
