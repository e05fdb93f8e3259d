#pragma once

#include <planish/job/slit_json.hpp>
#include <planish/schema/json_reading.hpp>
#include <planish/schema/schema.hpp>

#include <string>
#include <vector>

namespace planish::job {

/// The keys of a slit file that say what acts on strips: material, gravity, loads, coupling.
std::vector<schema::Field> load_fields();

/// Reads them. Returns the name of the material's file, which is read apart; empty without one.
std::string take_loads(const schema::JsonPlace& place, SlitDesign& design);

/// Takes the material of such a file (formats.md#material), as far as a sheet is elastic, if there
/// is a name and a folder. Errors: `cannot_read`, `invalid_input`, also of a file that tells no
/// modulus.
Result<void> take_material(const std::string& name,
                           const std::optional<std::filesystem::path>& folder, SlitDesign& design);

}  // namespace planish::job
