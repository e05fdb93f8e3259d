#pragma once

#include <planish/base/result.hpp>
#include <planish/connect/plates.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/job/request.hpp>

#include <optional>
#include <string>
#include <vector>

namespace planish::job {

/// What a bend of a plates file leaves to the defaults.
struct OpenKeys {
  bool inside_radius = false, lateral = false, trade_off = false;
};

/// The content of a plates file (formats.md#plates; docs/connect.md), lengths in mm.
struct PlatesFile {
  PlateStructure structure;    ///< its bends have the defaults
  std::vector<OpenKeys> open;  ///< by bend
  std::optional<double> k_factor;
  LengthUnit units = LengthUnit::mm;  ///< of the file
};

/// The structure, with what the options of a request say instead of the file's defaults.
PlateStructure with_options(const PlatesFile& file, const JoinOptions& options);

/// Reads a plates file. Errors: `invalid_input` for anything that is not JSON (`where` is
/// name:line:column), unknown, repeated and missing keys, values of the wrong type or out of range,
/// two plates with one id, and properties of a bend that exclude each other (`where` is name and
/// JSON pointer). `connect` checks that plates and edges exist and that bends fit.
Result<PlatesFile> parse_plates(const std::string& json, const std::string& name);

}  // namespace planish::job
