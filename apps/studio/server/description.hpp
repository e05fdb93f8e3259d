#pragma once

#include "../work/answer.hpp"

#include <planish/job/artifact.hpp>

namespace planish::studio {

/// What can be opened, asked and written, as in docs/studio-api.md; the page builds its menus from
/// it.
Answer description(const job::Catalogue& catalogue);

}  // namespace planish::studio
