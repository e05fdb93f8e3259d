# Run as a script: writes a C++ file that carries files in the program.
#
#   cmake -D OUTPUT=<file.cpp> -D HEADER=<embedded.hpp> -D TREES=<tree>[::<tree>...] -P PlanishEmbed.cmake
#
# A tree is <prefix>=<folder>,<glob>[|<glob>...].
#
# Every file of a tree that a glob finds is called <prefix>/<path below the folder>; all of them stand in the
# order of their names. Contents are brought in by the assembler.

set(names "")
string(REPLACE "::" ";" trees "${TREES}")
foreach(tree IN LISTS trees)
  string(REGEX MATCH "^([^=]+)=([^,]+),(.+)$" _ "${tree}")
  set(prefix "${CMAKE_MATCH_1}")
  set(folder "${CMAKE_MATCH_2}")
  string(REPLACE "|" ";" globs "${CMAKE_MATCH_3}")
  foreach(glob IN LISTS globs)
    file(GLOB_RECURSE found RELATIVE "${folder}" "${folder}/${glob}")
    foreach(path IN LISTS found)
      list(APPEND names "${prefix}/${path}")
      set("file_${prefix}/${path}" "${folder}/${path}")
    endforeach()
  endforeach()
endforeach()
list(REMOVE_DUPLICATES names)
list(SORT names COMPARE STRING)

set(blocks "")
set(declarations "")
set(rows "")
set(number 0)
foreach(name IN LISTS names)
  set(path "${file_${name}}")
  # A file that changes changes this text, and so what is compiled anew.
  file(SHA256 "${path}" hash)
  string(APPEND blocks
    "// ${hash}\n"
    "asm(\".pushsection .rodata\\n\"\n"
    "    \".global planish_embedded_${number}\\nplanish_embedded_${number}:\\n.incbin \\\"${path}\\\"\\n\"\n"
    "    \".global planish_embedded_${number}_end\\nplanish_embedded_${number}_end:\\n.byte 0\\n.popsection\\n\");\n")
  string(APPEND declarations "extern const char planish_embedded_${number}[], planish_embedded_${number}_end[];\n")
  string(APPEND rows "      {\"${name}\", {planish_embedded_${number}, planish_embedded_${number}_end}},\n")
  math(EXPR number "${number} + 1")
endforeach()

file(WRITE "${OUTPUT}"
"// Written by cmake/PlanishEmbed.cmake.
#include \"${HEADER}\"

#include <array>

${blocks}
extern \"C\" {
${declarations}}

namespace planish::studio {

std::span<const EmbeddedFile> embedded_files() {
  static const std::array<EmbeddedFile, ${number}> files{{
${rows}  }};
  return files;
}

}  // namespace planish::studio
")
