#pragma once

#include <planish/job/maker.hpp>

namespace planish::job {

/// The maker of docs/extending.md: a round flat plate, from {"radius": r, "thickness": t}.
Maker disc_maker();

}  // namespace planish::job
