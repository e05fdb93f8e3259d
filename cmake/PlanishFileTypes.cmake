# What desktops and the studio know of the files that makers read.
#
#   planish_file_type(<name> <comment> <comment in German> [EXAMPLES <glob>...])
#     "planish/<name>" is the value of their key "format"; the globs are below examples/
#   planish_write_desktop_files(<folder>)
#     packaging/desktop/*.in with all file types, in the order of the calls
#
# @PLANISH_FILE_TYPES@ stands for types in shared-mime-info, @PLANISH_MIME_LIST@ for their names in a desktop entry,
# @PLANISH_MEDIA_TYPES@ in AppStream.

function(planish_file_type name comment german)
  cmake_parse_arguments(PARSE_ARGV 3 arg "" "" "EXAMPLES")
  set_property(GLOBAL APPEND PROPERTY PLANISH_FILE_TYPES "${name}=${comment}=${german}")
  set_property(GLOBAL APPEND PROPERTY PLANISH_EXAMPLES ${arg_EXAMPLES})
endfunction()

function(planish_write_desktop_files folder)
  get_property(types GLOBAL PROPERTY PLANISH_FILE_TYPES)
  foreach(type IN LISTS types)
    string(REGEX MATCH "^([^=]+)=([^=]+)=(.+)$" _ "${type}")
    set(mime "application/vnd.planish.${CMAKE_MATCH_1}+json")
    string(APPEND PLANISH_MIME_LIST "${mime};")
    string(APPEND PLANISH_MEDIA_TYPES "\n    <mediatype>${mime}</mediatype>")
    string(APPEND PLANISH_FILE_TYPES "
  <mime-type type=\"${mime}\">
    <comment>${CMAKE_MATCH_2}</comment>
    <comment xml:lang=\"de\">${CMAKE_MATCH_3}</comment>
    <sub-class-of type=\"application/json\"/>
    <magic priority=\"80\">
      <match type=\"string\" value=\"&quot;planish/${CMAKE_MATCH_1}&quot;\" offset=\"0:1024\"/>
    </magic>
  </mime-type>")
  endforeach()
  foreach(file planish.xml planish-studio.desktop org.planish.studio.metainfo.xml)
    configure_file("${PROJECT_SOURCE_DIR}/packaging/desktop/${file}.in" "${folder}/${file}" @ONLY)
  endforeach()
endfunction()
