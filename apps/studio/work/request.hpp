#pragma once

#include <planish/base/result.hpp>
#include <planish/job/run.hpp>

#include <string>

namespace planish::studio {

inline constexpr auto kOptions = "/options";  ///< where they stand in a request

/// A request of docs/studio-api.md, read.
struct Asked {
  std::string key;   ///< the whole request as text: equal requests have equal keys
  std::string spec;  ///< JSON text; empty: none
  job::Request request;
};

/// Errors: `invalid_input` for anything that is not JSON, unknown keys, options that the maker does
/// not take, values of another kind or outside their range (`where` is the JSON pointer).
Result<Asked> parse_asked(const std::string& json, const job::Maker& maker);

}  // namespace planish::studio
