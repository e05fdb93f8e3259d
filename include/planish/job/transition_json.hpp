#pragma once

#include <planish/base/result.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/transition/transition.hpp>

#include <string>

namespace planish::job {

/// The content of a transition file (formats.md#transition; docs/transition.md), lengths in mm.
struct TransitionFile {
  TransitionSpec spec;
  LengthUnit units = LengthUnit::mm;  ///< of the file
  bool has_default_k = false;         ///< the file says no K
};

/// Reads a transition file. Errors: `invalid_input` for anything that is not JSON (`where` is
/// name:line:column), unknown, repeated and missing keys, values of the wrong type or out of range
/// (`where` is name and JSON pointer). `make_transition` checks the profiles themselves.
Result<TransitionFile> parse_transition(const std::string& json, const std::string& name);

}  // namespace planish::job
