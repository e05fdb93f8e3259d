# planish_module(<name> [USES <module>...] [PUBLIC_LIBS <lib>...] [PRIVATE_LIBS <lib>...])
#
# Makes of one module
#   planish_<name>      the library (alias planish::<name>) from src/<name>/**.cpp; an INTERFACE
#                       library where the module is headers only
#   <name>_headers      every public header compiled on its own, with PLANISH_TESTS
#   <name>_tests        one GoogleTest program from tests/<name>/**.cpp, with PLANISH_TESTS
#   <name>_bench        one Google Benchmark program from bench/<name>/*_bench.cpp, with
#                       PLANISH_BENCH
#
# USES are the modules it may include; PUBLIC_LIBS the libraries that appear in its headers;
# PRIVATE_LIBS those that appear in its sources (and in its tests) only.
#
# Walls. An include that this table does not allow does not compile:
# - the include directory of a module, walls/<name> in the build tree, holds planish/<name> and
#   nothing else, so that only the modules in USES (and what those use) can be found;
# - a library of PLANISH_WALLED_LIBS whose headers lie in /usr/include, where every compiler
#   looks, is hidden from the modules that do not list it behind headers that are an #error.
#
# A module that has no sources yet, or uses one that has none, is skipped with a status line.
#
# Sources are globbed, against CMake's advice: there is one rule for all modules, where a file
# lies says what it belongs to, and CONFIGURE_DEPENDS notices a new file at the next build.

# <library>=<header>[,<header>...]
set(PLANISH_WALLED_LIBS
  GEOS::geos_c=geos_c.h,geos.h
  Dxflib::dxflib=dxflib/dl_dxf.h,dxflib/dl_creationadapter.h,dxflib/dl_creationinterface.h
  nlohmann_json::nlohmann_json=nlohmann/json.hpp,nlohmann/json_fwd.hpp
  CLI11::CLI11=CLI/CLI.hpp,CLI/App.hpp
  TinySolver::TinySolver=ceres/ceres.h,ceres/problem.h,ceres/solver.h,ceres/cost_function.h,ceres/manifold.h,ceres/jet.h,ceres/tiny_solver.h
  nanoflann::nanoflann=nanoflann.hpp
  ccd=ccd/ccd.h
  Nest2d::nest2d=libnest2d/libnest2d.hpp,libnest2d/nester.hpp,polyclipping/clipper.hpp
  Cairo::headers=cairo/cairo.h,cairo/cairo-pdf.h
  Httplib::httplib=httplib.h
  ZLIB::ZLIB=zlib.h
  Cbc::Cbc=coin/Cbc_C_Interface.h)

# Hides the headers of every walled library that is not among the given ones from `target`.
function(_planish_hide_libs target)
  foreach(entry IN LISTS PLANISH_WALLED_LIBS)
    string(REGEX MATCH "^(.+)=(.+)$" _ "${entry}")
    set(lib "${CMAKE_MATCH_1}")
    string(REPLACE "," ";" headers "${CMAKE_MATCH_2}")
    if("${ARGN}" MATCHES "${lib}")
      continue()
    endif()
    string(MAKE_C_IDENTIFIER "${lib}" folder)
    set(folder "${PROJECT_BINARY_DIR}/walls/hidden/${folder}")
    foreach(header IN LISTS headers)
      file(CONFIGURE OUTPUT "${folder}/${header}"
        CONTENT "#error \"wall: this module may not include ${lib} (see CMakeLists.txt)\"\n")
    endforeach()
    target_include_directories(${target} BEFORE PRIVATE "${folder}")
  endforeach()
endfunction()

function(planish_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES;PUBLIC_LIBS;PRIVATE_LIBS")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "planish_module(${name}): unknown arguments ${arg_UNPARSED_ARGUMENTS}")
  endif()
  set(target planish_${name})
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS
    RELATIVE "${PROJECT_SOURCE_DIR}/include" "${PROJECT_SOURCE_DIR}/include/planish/${name}/*.hpp")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/${name}/*.cpp")

  if(NOT headers)
    message(STATUS "planish: module ${name} skipped, it has no header yet")
    return()
  endif()
  foreach(used IN LISTS arg_USES)
    if(NOT TARGET planish_${used})
      message(STATUS "planish: module ${name} skipped, it uses ${used}")
      return()
    endif()
  endforeach()

  set(wall "${PROJECT_BINARY_DIR}/walls/${name}")
  file(MAKE_DIRECTORY "${wall}/planish")
  file(CREATE_LINK "${PROJECT_SOURCE_DIR}/include/planish/${name}" "${wall}/planish/${name}"
    SYMBOLIC)

  if(sources)
    add_library(${target} ${sources})
    planish_group_sources(${target} ${sources})
    target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/src/${name}")
    target_link_libraries(${target} PRIVATE ${arg_PRIVATE_LIBS})
    _planish_hide_libs(${target} ${arg_PUBLIC_LIBS} ${arg_PRIVATE_LIBS})
    # What its sources are compiled with, for tests/walls.
    file(GENERATE OUTPUT "${wall}.includes"
      CONTENT "$<JOIN:$<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>,\n>\n")
    set(visible PUBLIC)
  else()
    add_library(${target} INTERFACE)
    file(REMOVE "${wall}.includes")
    set(visible INTERFACE)
  endif()
  add_library(planish::${name} ALIAS ${target})
  list(TRANSFORM arg_USES PREPEND planish:: OUTPUT_VARIABLE used_targets)
  target_link_libraries(${target} ${visible} ${used_targets} ${arg_PUBLIC_LIBS})
  target_include_directories(${target} ${visible}
    $<BUILD_INTERFACE:${wall}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${target} ${visible} cxx_std_20)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  set_property(GLOBAL APPEND PROPERTY PLANISH_MODULES ${name})

  if(PLANISH_TESTS)
    _planish_module_headers(${name} "${arg_PUBLIC_LIBS}" ${headers})
    set(support "")
    if(sheet IN_LIST arg_USES OR name STREQUAL sheet)
      set(support planish_test_support)
    endif()
    _planish_module_tests(${name} ${arg_PRIVATE_LIBS} ${support})
  endif()
  if(PLANISH_BENCH)
    _planish_module_bench(${name} ${arg_PRIVATE_LIBS})
  endif()
endfunction()

# Each public header must compile alone and must not need what the module keeps private.
function(_planish_module_headers name public_libs)
  set(probes "")
  foreach(header IN LISTS ARGN)
    set(probe "${PROJECT_BINARY_DIR}/headers/${header}.cpp")
    file(CONFIGURE OUTPUT "${probe}" CONTENT "#include <${header}>\n")
    list(APPEND probes "${probe}")
  endforeach()
  add_library(${name}_headers OBJECT ${probes})
  target_link_libraries(${name}_headers PRIVATE planish::${name})
  # Nobody runs them.
  target_compile_options(${name}_headers PRIVATE -O0 -g0)
  _planish_hide_libs(${name}_headers ${public_libs})
endfunction()

# Tests see what the module's sources see, tests/ itself (`#include "support/..."`; what has sources
# there uses sheet, and is linked to the tests of sheet and of those that use it), and
#   PLANISH_SOURCE_DIR   the repository
#   PLANISH_PYTHON       the interpreter that has the packages the tests need
function(_planish_module_tests name)
  file(GLOB_RECURSE tests CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/${name}/*.cpp")
  if(NOT tests)
    message(STATUS "planish: module ${name} has no tests yet")
    return()
  endif()
  add_executable(${name}_tests ${tests})
  planish_group_sources(${name}_tests ${tests})
  target_link_libraries(${name}_tests
    PRIVATE planish::${name} ${ARGN} GTest::gmock GTest::gtest_main rapidcheck_gtest)
  target_include_directories(${name}_tests
    PRIVATE "${PROJECT_SOURCE_DIR}/tests" "${PROJECT_SOURCE_DIR}/src/${name}")
  # Compiling them costs more than running them: docs/decisions/0005-build-time.md.
  target_compile_options(${name}_tests PRIVATE $<$<CONFIG:Release>:-O1>)
  target_compile_definitions(${name}_tests
    PRIVATE PLANISH_SOURCE_DIR="${PROJECT_SOURCE_DIR}" PLANISH_PYTHON="${PLANISH_PYTHON}")
  include(GoogleTest)
  gtest_discover_tests(${name}_tests
    DISCOVERY_MODE PRE_TEST
    PROPERTIES LABELS ${name} TIMEOUT 300)
endfunction()

function(_planish_module_bench name)
  file(GLOB_RECURSE benches CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/bench/${name}/*_bench.cpp")
  if(NOT benches)
    return()
  endif()
  add_executable(${name}_bench ${benches})
  # Benches measure the same sheets that tests check.
  target_link_libraries(${name}_bench
    PRIVATE planish::${name} ${ARGN} benchmark::benchmark_main planish_test_support)
  target_include_directories(${name}_bench
    PRIVATE "${PROJECT_SOURCE_DIR}/bench" "${PROJECT_SOURCE_DIR}/tests"
            "${PROJECT_SOURCE_DIR}/src/${name}")
  target_compile_definitions(${name}_bench PRIVATE PLANISH_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
endfunction()
