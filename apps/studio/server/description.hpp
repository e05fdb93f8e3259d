#pragma once

#include "../work/answer.hpp"

#include <planish/job/artifact.hpp>

namespace planish::studio {

/// What can be opened, asked and written, as docs/studio-api.md has it: the page makes its menus
/// of it.
Answer description(const job::Catalogue& catalogue);

}  // namespace planish::studio
