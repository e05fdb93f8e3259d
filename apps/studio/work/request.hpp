#pragma once

#include <planish/base/result.hpp>
#include <planish/job/run.hpp>

#include <optional>
#include <string>

namespace planish::studio {

inline constexpr auto kOptions = "/options";  ///< where they are in a request
inline constexpr auto kBrake = "/brake";

/// A parsed request of docs/studio-api.md.
struct Asked {
  std::string key;   ///< spec and options, but those of the DXF: of the same geometry equal
  std::string spec;  ///< JSON text; empty: none
  job::Request request;
  std::optional<double> chord;  ///< how far facets may lie from curves, mm
  std::string brake = "{}";     ///< options of the press brake, JSON text
  std::string order;            ///< of strokes, JSON text; empty: none is given
};

/// Errors: `invalid_input` for anything that is not JSON, unknown keys, options that the maker does
/// not take, values of the wrong type or out of range (`where` is the JSON pointer).
Result<Asked> parse_asked(const std::string& json, const job::Maker& maker);

}  // namespace planish::studio
