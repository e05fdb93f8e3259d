#pragma once

#include <planish/base/result.hpp>
#include <planish/connect/plates.hpp>
#include <planish/io/flat_writers.hpp>

#include <optional>
#include <string>

namespace planish::job {

/// What a plates file says (formats.md#plates; docs/connect.md), lengths in mm.
struct PlatesFile {
  PlateStructure structure;
  std::optional<double> k_factor;
  LengthUnit units = LengthUnit::mm;  ///< of the file
};

/// Reads a plates file. Errors: `invalid_input` for anything that is not JSON (`where` is
/// name:line:column), unknown, repeated and missing keys, values of another kind or outside their
/// range, two plates of one id, and things said of a bend that exclude each other (`where` is name
/// and JSON pointer). Whether plates and edges exist and bends fit is left to `connect`.
Result<PlatesFile> parse_plates(const std::string& json, const std::string& name);

}  // namespace planish::job
