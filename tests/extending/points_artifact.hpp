#pragma once

#include <planish/job/artifact.hpp>

namespace planish::job {

/// The artifact of docs/extending.md: the outer contour as points, "x,y" a line, in mm.
Artifact points_artifact();

}  // namespace planish::job
