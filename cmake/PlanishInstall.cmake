# `cmake --install` and the CMake package `planish` (targets planish::job, planish::io, ...); of the C interface
# the target planish::c, which needs none of the others' libraries, and planish.pc.
#
# What is installed belongs to a component that is called like the Debian package that it goes into
# (docs/packages.md): planish, libplanish1, libplanish-dev, python3-planish, freecad-planish.

include(CMakePackageConfigHelpers)

get_property(planish_modules GLOBAL PROPERTY PLANISH_MODULES)
if(NOT planish_modules)
  return()
endif()
set(planish_cmake_dir "${CMAKE_INSTALL_LIBDIR}/cmake/planish")
set(PLANISH_ZSH_DIR "${CMAKE_INSTALL_DATADIR}/zsh/site-functions" CACHE STRING
  "Where zsh looks for completion; Debian's is share/zsh/vendor-completions")
set(PLANISH_FREECAD_DIR "${CMAKE_INSTALL_DATADIR}/freecad/Mod" CACHE STRING
  "Where FreeCAD looks for workbenches")

foreach(module IN LISTS planish_modules)
  install(TARGETS planish_${module} EXPORT planish_targets COMPONENT libplanish-dev)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/planish/${module}"
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/planish" COMPONENT libplanish-dev
    FILES_MATCHING PATTERN "*.hpp")
endforeach()
if(TARGET planish_c)
  # With shared modules it comes with them, which it loads.
  set(planish_c_export planish_c_targets)
  if(BUILD_SHARED_LIBS)
    set(planish_c_export planish_targets)
  endif()
  install(TARGETS planish_c EXPORT ${planish_c_export}
    LIBRARY COMPONENT libplanish1 NAMELINK_COMPONENT libplanish-dev)
  install(FILES "${PROJECT_SOURCE_DIR}/include/planish/planish.h"
    DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/planish" COMPONENT libplanish-dev)
  if(NOT BUILD_SHARED_LIBS)
    install(EXPORT planish_c_targets
      FILE planishCTargets.cmake NAMESPACE planish:: DESTINATION "${planish_cmake_dir}"
      COMPONENT libplanish-dev)
  endif()
  # Where the installed tree is moved to, pkg-config finds it by the place of planish.pc.
  set(planish_pc_dir "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
  file(RELATIVE_PATH planish_pc_prefix "${CMAKE_INSTALL_PREFIX}/${planish_pc_dir}" "${CMAKE_INSTALL_PREFIX}")
  configure_file("${PROJECT_SOURCE_DIR}/cmake/planish.pc.in" "${PROJECT_BINARY_DIR}/planish.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/planish.pc" DESTINATION "${planish_pc_dir}" COMPONENT libplanish-dev)
endif()

install(EXPORT planish_targets
  FILE planishTargets.cmake NAMESPACE planish:: DESTINATION "${planish_cmake_dir}"
  COMPONENT libplanish-dev)
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
  DESTINATION "${planish_cmake_dir}" COMPONENT libplanish-dev)
# Debian has it already, and it goes into no package.
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT licence)

# The workbench for FreeCAD.
install(DIRECTORY "${PROJECT_SOURCE_DIR}/integrations/freecad/"
  DESTINATION "${PLANISH_FREECAD_DIR}/Planish" COMPONENT freecad-planish
  PATTERN "__pycache__" EXCLUDE)

if(NOT TARGET planish)
  return()
endif()
install(TARGETS planish COMPONENT planish)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/docs" DESTINATION "${CMAKE_INSTALL_DOCDIR}"
  COMPONENT planish PATTERN "decisions" EXCLUDE)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/examples" DESTINATION "${CMAKE_INSTALL_DOCDIR}"
  COMPONENT planish PATTERN "__pycache__" EXCLUDE)
install(DIRECTORY "${PROJECT_BINARY_DIR}/written/man1" DESTINATION "${CMAKE_INSTALL_MANDIR}"
  COMPONENT planish OPTIONAL)
foreach(shell_and_place
    "bash=${CMAKE_INSTALL_DATADIR}/bash-completion/completions"
    "zsh=${PLANISH_ZSH_DIR}"
    "fish=${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d")
  string(REGEX MATCH "^([a-z]+)=(.+)$" _ "${shell_and_place}")
  install(DIRECTORY "${PROJECT_BINARY_DIR}/written/${CMAKE_MATCH_1}/" DESTINATION "${CMAKE_MATCH_2}"
    COMPONENT planish OPTIONAL)
endforeach()

if(TARGET planish_studio_program)
  set(desktop "${PROJECT_SOURCE_DIR}/packaging/desktop")
  install(TARGETS planish_studio_program COMPONENT planish)
  set(written_desktop "${PROJECT_BINARY_DIR}/desktop")
  planish_write_desktop_files("${written_desktop}")
  install(FILES "${written_desktop}/planish-studio.desktop"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/applications" COMPONENT planish)
  install(FILES "${written_desktop}/planish.xml"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/mime/packages" COMPONENT planish)
  install(FILES "${desktop}/planish-studio.svg"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps" COMPONENT planish)
  install(FILES "${written_desktop}/org.planish.studio.metainfo.xml"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/metainfo" COMPONENT planish)
endif()
