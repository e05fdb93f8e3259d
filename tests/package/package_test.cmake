# Installs planish into an empty prefix, then configures, builds and runs programs against it: one in C++, and one
# in C by its CMake package and by pkg-config, and the programs of examples/programs:
#   cmake -D build=... -D scratch=... -D compiler=... -D c_compiler=... -D python=... -D examples=... -P package_test.cmake

set(part "${examples}/bracket.step")
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${scratch}")
run("${CMAKE_COMMAND}" --install "${build}" --prefix "${scratch}/first")
# An installed tree may be moved.
file(RENAME "${scratch}/first" "${scratch}/prefix")
run("${CMAKE_COMMAND}" -G Ninja -S "${CMAKE_CURRENT_LIST_DIR}" -B "${scratch}/build"
  "-DCMAKE_PREFIX_PATH=${scratch}/prefix" "-DCMAKE_CXX_COMPILER=${compiler}"
  "-DCMAKE_CXX_FLAGS=${flags}")
run("${CMAKE_COMMAND}" --build "${scratch}/build")
run("${scratch}/build/consumer" "${part}")
run("${python}" "${CMAKE_CURRENT_LIST_DIR}/programs_test.py" "${scratch}/build" "${examples}")

run("${CMAKE_COMMAND}" -G Ninja -S "${CMAKE_CURRENT_LIST_DIR}/c" -B "${scratch}/build_c"
  "-DCMAKE_PREFIX_PATH=${scratch}/prefix" "-DCMAKE_C_COMPILER=${c_compiler}" "-DCMAKE_C_FLAGS=${flags}")
run("${CMAKE_COMMAND}" --build "${scratch}/build_c")
run("${scratch}/build_c/consumer" "${part}")

file(GLOB_RECURSE pc "${scratch}/prefix/*/planish.pc")
get_filename_component(pc_folder "${pc}" DIRECTORY)
set(ENV{PKG_CONFIG_PATH} "${pc_folder}")
execute_process(COMMAND pkg-config --cflags --libs planish
  OUTPUT_VARIABLE words OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(words UNIX_COMMAND "${words}")
separate_arguments(flag_words UNIX_COMMAND "${flags}")
run("${c_compiler}" -std=c99 ${flag_words} "${CMAKE_CURRENT_LIST_DIR}/c/main.c" ${words} -o "${scratch}/consumer_pc")
execute_process(COMMAND pkg-config --variable=libdir planish
  OUTPUT_VARIABLE libraries OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
run("${CMAKE_COMMAND}" -E env "LD_LIBRARY_PATH=${libraries}" "${scratch}/consumer_pc" "${part}")
