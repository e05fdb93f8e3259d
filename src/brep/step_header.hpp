#pragma once

#include <planish/base/result.hpp>

#include <string>
#include <string_view>

namespace planish::brep {

/// What the header section of a STEP file states about itself.
struct StepHeader {
  std::string schema;      ///< "AP214 (AUTOMOTIVE_DESIGN …)"
  std::string cad_system;  ///< FILE_NAME's originating system, else its preprocessor
};

/// Whether a text begins as a STEP file does.
bool begins_as_step(std::string_view text);

/// Checks that a text is a whole ISO 10303-21 exchange file and reads its header. Errors:
/// `empty_file`, `not_step`, `truncated_file`, `no_solid` for one that holds nothing, each naming
/// `name`.
Result<StepHeader> read_step_header(std::string_view text, const std::string& name);

}  // namespace planish::brep
