# `cmake --install` and the CMake package `planish` (targets planish::job, planish::io, ...); of the C interface
# the target planish::c, a component of its own that needs none of the others' libraries, and planish.pc.

include(CMakePackageConfigHelpers)

get_property(planish_modules GLOBAL PROPERTY PLANISH_MODULES)
if(NOT planish_modules)
  return()
endif()
set(planish_cmake_dir "${CMAKE_INSTALL_LIBDIR}/cmake/planish")

foreach(module IN LISTS planish_modules)
  install(TARGETS planish_${module} EXPORT planish_targets)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/planish/${module}"
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/planish" FILES_MATCHING PATTERN "*.hpp")
endforeach()
if(TARGET planish_c)
  # With shared modules it comes with them, which it loads.
  set(planish_c_export planish_c_targets)
  if(BUILD_SHARED_LIBS)
    set(planish_c_export planish_targets)
  endif()
  install(TARGETS planish_c EXPORT ${planish_c_export})
  install(FILES "${PROJECT_SOURCE_DIR}/include/planish/planish.h"
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/planish")
  if(NOT BUILD_SHARED_LIBS)
    install(EXPORT planish_c_targets
      FILE planishCTargets.cmake NAMESPACE planish:: DESTINATION "${planish_cmake_dir}")
  endif()
  # Where the installed tree is moved to, pkg-config finds it by the place of planish.pc.
  set(planish_pc_dir "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
  file(RELATIVE_PATH planish_pc_prefix "${CMAKE_INSTALL_PREFIX}/${planish_pc_dir}" "${CMAKE_INSTALL_PREFIX}")
  configure_file("${PROJECT_SOURCE_DIR}/cmake/planish.pc.in" "${PROJECT_BINARY_DIR}/planish.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/planish.pc" DESTINATION "${planish_pc_dir}")
endif()
if(TARGET planish)
  install(TARGETS planish)
endif()
if(TARGET planish_studio_program)
  install(TARGETS planish_studio_program)
endif()

install(EXPORT planish_targets
  FILE planishTargets.cmake NAMESPACE planish:: DESTINATION "${planish_cmake_dir}")
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/planishConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/planishConfig.cmake" INSTALL_DESTINATION "${planish_cmake_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/planishConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/planishConfig.cmake"
  "${PROJECT_BINARY_DIR}/planishConfigVersion.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindDxflib.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindNest2d.cmake"
  "${PROJECT_SOURCE_DIR}/cmake/FindOcct.cmake"
  DESTINATION "${planish_cmake_dir}")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
