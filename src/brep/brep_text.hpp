#pragma once

#include "product_tree.hpp"

#include <string>
#include <string_view>

namespace planish::brep {

/// Whether bytes are a shape in the kernel's own form, text or binary (.brep, .bbrep), as programs
/// built on the kernel exchange them.
bool is_kernel_shape(std::string_view bytes);

/// Reads one. Lengths are mm; nothing has a name. Errors: `invalid_input` (damaged),
/// `too_far_away`, `no_solid` (it holds nothing).
Result<ProductTree> read_kernel_shape(const std::string& bytes, const std::string& name);

}  // namespace planish::brep
