#pragma once

#include <TopoDS_Shell.hxx>

namespace planish::brep {

/// Whether the kernel finds a closed shell sound: its faces, edges and vertices, that it is closed
/// and its faces look the same way. Of a plane face with many contours each is looked at by itself,
/// since the kernel's own check takes the square of its edges; that contours of one face keep clear
/// of each other is then left to the checks of the pattern. Near-linear for short contours.
bool is_sound(const TopoDS_Shell& shell);

}  // namespace planish::brep
