#pragma once

#include <planish/base/message.hpp>
#include <planish/sheet/codes.hpp>

/// The sentences with which nest refuses.
namespace planish::refuse {

constexpr Refusal cancelled{code::cancelled, "Nesting was cancelled."};
constexpr Refusal bad_nest_option{code::bad_option, "{name} is {value}, which is out of range.",
                                  "Set it to {range}."};
constexpr Refusal bad_quantity{code::bad_option, "Part {part} is wanted {quantity:time}.",
                               "Ask for it once or more, or leave it out."};
constexpr Refusal no_outer_contour{code::invalid_sheet, "Part {part} has no outer contour."};
constexpr Refusal parts_overlap{code::internal, "Two parts of the nesting overlap."};
constexpr Refusal wrong_quantity{code::internal,
                                 "The nesting does not hold every part in its quantity."};

}  // namespace planish::refuse
