#pragma once

#include <planish/base/message.hpp>
#include <planish/io/codes.hpp>
#include <planish/sheet/codes.hpp>

/// The sentences with which io refuses.
namespace planish::refuse {

constexpr Refusal bad_dxf_option{code::bad_option, "`{option}` is {value}, which is out of range.",
                                 "Set it to a value above 0."};
constexpr Refusal bad_sheet_size{code::bad_option,
                                 "The sheet is {length} × {width}, which is out of range.",
                                 "Set both to values above 0."};
constexpr Refusal no_outer_contour{code::invalid_sheet, "The pattern has no outer contour."};
constexpr Refusal contour_without_extent{code::internal,
                                         "The pattern has a contour without extent."};

constexpr Refusal cannot_write{code::cannot_write, "Cannot write {file}: {reason}."};
constexpr Refusal cannot_make_folder{code::cannot_write,
                                     "Cannot make the folder {file}: {reason}."};

constexpr Refusal nothing_to_draw{code::cannot_draw, "There is nothing to draw."};
constexpr Refusal no_cairo{code::cannot_draw, "A PDF needs {library}, which this machine lacks.",
                           "Install libcairo2."};
constexpr Refusal old_cairo{code::cannot_draw, "This machine's {library} has no {function}.",
                            "Install a newer libcairo2."};
constexpr Refusal no_font{code::cannot_draw, "A PDF needs a font, and this machine has none.",
                          "Install fonts-dejavu-core."};
constexpr Refusal cairo_failed{code::cannot_draw, "Cairo could not draw the pages: {reason}."};

constexpr Refusal unreadable_pattern{
    code::invalid_input, "The stored flat pattern cannot be read: {why}.", "Make it again."};

}  // namespace planish::refuse
