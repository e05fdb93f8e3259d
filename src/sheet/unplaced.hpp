#pragma once

#include <planish/sheet/layout.hpp>

#include <string>

namespace planish::sheet_detail {

/// A layout with its bends developed and no face placed yet. Errors: those of `lay_out` that do not
/// come from joints.
Result<Layout> unplaced(const Sheet& sheet, const FlattenOptions& options);

/// The largest face of a flange; the first face if there is no flange.
FaceId largest_flange_face(const Sheet& sheet);

/// The place of a joint by the numbers of its faces: "between face 7 and face 9".
std::string between_faces(const Sheet& sheet, const Joint& joint);

}  // namespace planish::sheet_detail
