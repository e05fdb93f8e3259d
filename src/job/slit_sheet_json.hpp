#pragma once

#include <planish/schema/json_reading.hpp>
#include <planish/schema/schema.hpp>
#include <planish/slit/slit_curves.hpp>

#include <vector>

namespace planish::job {

/// The key `sheet` of a slit file, and those of slits that are curves and of the outline of their
/// sheet (formats.md#slit-curves).
schema::Schema slit_sheet_schema();
std::vector<schema::Field> slit_curve_fields();

/// The sheet, without its thickness; of strips between slits that are curves only their number.
/// Mistakes: strips of the sheet beside such slits, neither, an outline without them, a width
/// beside an outline or neither.
SlitSheet slit_sheet_at(const schema::JsonPlace& document);

/// The slits that are curves, their sheet's outline and width; nothing without them.
CurvedSlits slit_curves_at(const schema::JsonPlace& document);

}  // namespace planish::job
