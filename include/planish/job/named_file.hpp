#pragma once

#include <string>

namespace planish::job {

/// A file that an input file names, and the JSON pointer to its name.
struct NamedFile {
  std::string file, pointer;
};

}  // namespace planish::job
