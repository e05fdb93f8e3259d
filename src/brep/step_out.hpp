#pragma once

#include <planish/base/result.hpp>

#include <TopoDS_Shape.hxx>

#include <string>

namespace planish::brep {

/// The shape as STEP text: AP214, millimetres, one product of the given name (UTF-8). Equal shapes
/// and names give equal text: the header's time stamp is fixed. May throw the kernel's exceptions:
/// call it inside `guarded`. Takes the exchange lock. Errors: `internal` if the kernel fails.
Result<std::string> step_text(const TopoDS_Shape& shape, const std::string& name);

/// A string as the content of a STEP string literal: quotes and backslashes doubled, characters
/// other than printable ASCII as \X2\…\X0\ or \X4\…\X0\ (ISO 10303-21, 6.4.3). Bytes that are not
/// UTF-8
/// become U+FFFD.
std::string step_string(const std::string& utf8);

}  // namespace planish::brep
