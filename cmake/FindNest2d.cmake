# Finds libnest2d (Debian: libnest2d-dev, libpolyclipping-dev, libboost-dev), headers only, with
# Clipper, on which its geometry stands: Nest2d::nest2d. Its own CMake package is not used: Debian's
# names NLopt as well, which planish does without (docs/decisions/0014).

find_path(Nest2d_INCLUDE_DIR libnest2d/libnest2d.hpp)
find_path(Nest2d_CLIPPER_INCLUDE_DIR polyclipping/clipper.hpp)
find_path(Nest2d_BOOST_INCLUDE_DIR boost/geometry.hpp)
find_library(Nest2d_CLIPPER_LIBRARY polyclipping)
mark_as_advanced(Nest2d_INCLUDE_DIR Nest2d_CLIPPER_INCLUDE_DIR Nest2d_BOOST_INCLUDE_DIR
  Nest2d_CLIPPER_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Nest2d REQUIRED_VARS Nest2d_CLIPPER_LIBRARY Nest2d_INCLUDE_DIR
  Nest2d_CLIPPER_INCLUDE_DIR Nest2d_BOOST_INCLUDE_DIR)

if(Nest2d_FOUND AND NOT TARGET Nest2d::nest2d)
  add_library(Nest2d::nest2d UNKNOWN IMPORTED)
  set_target_properties(Nest2d::nest2d PROPERTIES
    IMPORTED_LOCATION "${Nest2d_CLIPPER_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${Nest2d_INCLUDE_DIR};${Nest2d_CLIPPER_INCLUDE_DIR}")
endif()
