#pragma once

#include <planish/base/result.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/job/report.hpp>
#include <planish/sheet/allowance.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace planish::studio {

/// A request of docs/studio-api.md, read.
struct Asked {
  std::string key;   ///< the whole request as text: equal requests have equal keys
  std::string spec;  ///< JSON text; empty: none
  int body = 1;
  std::string root = "largest", up = "auto";
  std::optional<AllowanceRule> k;
  std::vector<std::pair<std::string, double>> bend_k;
  std::optional<double> density;  ///< kg/dm³
  int piece = 0;
  std::optional<bool> align_scans;
  DxfOptions dxf;
  std::optional<LengthUnit> units;
};

/// Errors: `invalid_input` for anything that is not JSON, unknown keys, values of another kind or
/// outside their range
/// (`where` is the JSON pointer).
Result<Asked> parse_asked(const std::string& json);

/// The request to make a sheet of a spec file called `name`.
job::MakeRequest make_request(const Asked& asked, const std::string& name, job::Effort effort);

}  // namespace planish::studio
