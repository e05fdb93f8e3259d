#pragma once

#include "thicken.hpp"

#include <planish/base/result.hpp>
#include <planish/sheet/sheet.hpp>

#include <TopoDS_Shape.hxx>

namespace planish::brep {

struct ReferenceShellOptions : ThickenOptions {
  double joint_tolerance = 1e-3;  ///< mm: joints whose borders' ends lie farther apart stay open
};

/// The reference surface of a sheet as an open shell: its faces as they are, joints as shared
/// edges. Corners lie in the middle of those of the faces that meet there. Parts that no joint
/// connects are shells in a compound. The result has been checked by the kernel. May throw the
/// kernel's exceptions: call it inside `guarded`.
/// Errors: `invalid_input` (no faces, joints that do not fit), `unsupported_shape` (a bend without
/// radius), `internal` (the kernel finds the result invalid).
Result<TopoDS_Shape> reference_shell(const Sheet& sheet, const ReferenceShellOptions& options = {});

}  // namespace planish::brep
