#pragma once

#include <TCollection_HAsciiString.hxx>

#include <string>

namespace planish::brep {

/// A text of a STEP file as UTF-8, with the bytes that are none replaced; empty for none and for
/// blanks.
std::string step_text(const Handle(TCollection_HAsciiString) & text);

}  // namespace planish::brep
