# Finds dxflib (Debian: libdxflib-dev), which comes without a CMake package: Dxflib::dxflib.

find_path(Dxflib_INCLUDE_DIR dxflib/dl_dxf.h)
find_library(Dxflib_LIBRARY dxflib)
mark_as_advanced(Dxflib_INCLUDE_DIR Dxflib_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Dxflib REQUIRED_VARS Dxflib_LIBRARY Dxflib_INCLUDE_DIR)

if(Dxflib_FOUND AND NOT TARGET Dxflib::dxflib)
  add_library(Dxflib::dxflib UNKNOWN IMPORTED)
  set_target_properties(Dxflib::dxflib PROPERTIES
    IMPORTED_LOCATION "${Dxflib_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${Dxflib_INCLUDE_DIR}")
endif()
