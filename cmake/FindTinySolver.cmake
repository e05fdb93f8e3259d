# Finds Ceres's solver for small dense problems (Debian: libceres-dev): TinySolver::TinySolver. It
# is headers only; the rest of Ceres and what it needs are never linked.

find_path(TinySolver_INCLUDE_DIR ceres/tiny_solver.h)
mark_as_advanced(TinySolver_INCLUDE_DIR)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(TinySolver REQUIRED_VARS TinySolver_INCLUDE_DIR)

if(TinySolver_FOUND AND NOT TARGET TinySolver::TinySolver)
  add_library(TinySolver::TinySolver INTERFACE IMPORTED)
  set_target_properties(TinySolver::TinySolver PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${TinySolver_INCLUDE_DIR}")
endif()
