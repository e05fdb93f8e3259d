#pragma once

#include "rpc.hpp"

#include <planish/job/artifact.hpp>

#include <string>
#include <vector>

namespace planish::serve {

/// What a client can ask for: a method, and a tool of Model Context Protocol.
struct Tool {
  std::string name, description;
  Json schema;         ///< of its parameters, JSON Schema
  bool works = false;  ///< a worker does it; else it is answered at once
};

/// The makers of the catalogue, bend, info; and schema and formats, which are answered at once.
std::vector<Tool> tools_of(const job::Catalogue& catalogue);

/// What `schema` and `formats` answer. Errors: `bad_option` for a schema that there is not.
Result<Json> answer_at_once(const std::string& tool, const Json& parameters,
                            const job::Catalogue& catalogue);

}  // namespace planish::serve
