# Finds the headers of Cairo (Debian: libcairo2-dev): Cairo::headers. The library itself is loaded
# when something is drawn and never linked (docs/decisions/0012).

find_path(Cairo_INCLUDE_DIR cairo-pdf.h PATH_SUFFIXES cairo)
mark_as_advanced(Cairo_INCLUDE_DIR)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Cairo REQUIRED_VARS Cairo_INCLUDE_DIR)

if(Cairo_FOUND AND NOT TARGET Cairo::headers)
  add_library(Cairo::headers INTERFACE IMPORTED)
  set_target_properties(Cairo::headers PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${Cairo_INCLUDE_DIR}")
endif()
