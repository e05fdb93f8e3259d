# How everything here is compiled. Applies to this project only when it is the one being built;
# embedded in another, that project's choices hold.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# Most of what a source costs is the reading of headers, so files of a target are compiled several
# at a time, up to about 24 (docs/decisions/0005-build-time.md). A file's group depends on its name
# alone, and groups only ever split as a target grows: a new file joins one group and leaves the
# others as they are. Within a group, names in anonymous namespaces must differ; a file of SOURCES
# that is not to be grouped is left out of the call.
#   planish_group_sources(<target> <source>...)
function(planish_group_sources target)
  if(NOT PLANISH_UNITY)
    return()
  endif()
  set(groups 1)
  list(LENGTH ARGN count)
  while(count GREATER 24)
    math(EXPR groups "2 * ${groups}")
    math(EXPR count "${count} / 2")
  endwhile()
  foreach(source IN LISTS ARGN)
    get_filename_component(name "${source}" NAME_WE)
    string(SHA1 hash "${name}")
    string(SUBSTRING "${hash}" 0 4 hash)
    math(EXPR group "0x${hash} % ${groups}")
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${group}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

if(NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()

set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(BUILD_SHARED_LIBS)
  set(CMAKE_INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
endif()  # else a built program would look for every library in the working directory first

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

# The presets compile much the same files in different build trees. Paths relative to the
# repository, and a hash that leaves out the build tree's name, let them share the cache. What a
# source includes is known from the compiler, so that ccache need not preprocess it first.
find_program(PLANISH_CCACHE ccache)
if(PLANISH_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
    env "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1
    "${PLANISH_CCACHE}")
endif()

# Messages name a source as it lies in the repository, so that where that was does not show in what is built.
add_compile_options("-ffile-prefix-map=${PROJECT_SOURCE_DIR}/=")
add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # GCC 12 reports it, falsely, for every inlined copy of a std::variant that holds Eigen vectors.
  add_compile_options(-Wno-maybe-uninitialized)
endif()
if(PLANISH_WERROR)
  add_compile_options(-Werror)
endif()

if(PLANISH_LIBFUZZER)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
if(PLANISH_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all
                      -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
