# Finds the part of OpenCASCADE that brep uses: Occt::occt, with Occt_VERSION.
#
# OpenCASCADE's own CMake package is not used: it offers its toolkits only by whole groups, with
# the compiler flags and paths of the machine that built it, and the data-exchange group names
# visualization targets, so that whoever links an installed planish would need those too. The
# toolkits are shared libraries that know what they need; naming the ones we call is enough.

set(_occt_toolkits
  # foundation, geometry and topology
  TKernel TKMath TKG2d TKG3d TKGeomBase TKBRep
  # algorithms: primitives, booleans, fillets, offsets, healing, meshing
  TKGeomAlgo TKTopAlgo TKPrim TKBO TKBool TKFillet TKOffset TKShHealing TKMesh
  # STEP and STL
  TKXSBase TKSTEPBase TKSTEPAttr TKSTEP209 TKSTEP TKSTL)

find_path(Occt_INCLUDE_DIR Standard_Version.hxx PATH_SUFFIXES opencascade occt)
mark_as_advanced(Occt_INCLUDE_DIR)

set(Occt_VERSION "")
if(Occt_INCLUDE_DIR)
  file(STRINGS "${Occt_INCLUDE_DIR}/Standard_Version.hxx" _occt_version
    REGEX "^#define OCC_VERSION_COMPLETE")
  string(REGEX MATCH "[0-9]+(\\.[0-9]+)*" Occt_VERSION "${_occt_version}")
endif()

set(_occt_libraries "")
foreach(_toolkit IN LISTS _occt_toolkits)
  find_library(Occt_${_toolkit}_LIBRARY ${_toolkit})
  mark_as_advanced(Occt_${_toolkit}_LIBRARY)
  list(APPEND _occt_libraries Occt_${_toolkit}_LIBRARY)
endforeach()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Occt
  REQUIRED_VARS Occt_INCLUDE_DIR ${_occt_libraries}
  VERSION_VAR Occt_VERSION)

# Linker options that have a program load the toolkits that reading STEP takes before all other
# libraries.
set(Occt_LOAD_FIRST LINKER:--push-state,--no-as-needed)
foreach(_toolkit TKSTEPBase TKMath TKSTEPAttr TKXSBase TKGeomAlgo TKSTEP TKGeomBase TKernel TKG3d
    TKTopAlgo TKBRep TKShHealing TKSTEP209 TKMesh TKG2d)
  list(APPEND Occt_LOAD_FIRST "${Occt_${_toolkit}_LIBRARY}")
endforeach()
list(APPEND Occt_LOAD_FIRST LINKER:--pop-state)

if(Occt_FOUND AND NOT TARGET Occt::occt)
  add_library(Occt::occt INTERFACE IMPORTED)
  target_include_directories(Occt::occt SYSTEM INTERFACE "${Occt_INCLUDE_DIR}")
  # Loading a toolkit costs start-up time (some reach as far as OpenGL); only those that a
  # program does use are recorded in it.
  target_link_options(Occt::occt INTERFACE LINKER:--as-needed)
  foreach(_library IN LISTS _occt_libraries)
    target_link_libraries(Occt::occt INTERFACE "${${_library}}")
  endforeach()
endif()
