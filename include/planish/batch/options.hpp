#pragma once

#include <planish/batch/inputs.hpp>
#include <planish/job/request.hpp>

#include <optional>
#include <string>
#include <vector>

namespace planish::batch {

/// The request of options, a JSON object, of which each maker takes those that it has. Errors:
/// those of the options.
Result<job::Request> request_of(const std::string& options, const job::Catalogue& catalogue);

/// What is wrong with options with which no part can be made: a shop of several materials of which
/// nobody chooses one, quantities that are said twice; or with the options themselves. Files are
/// read for it only where nobody chooses, up to the first that names a material of the shop.
std::optional<Error> useless_options(const std::vector<Input>& inputs, const std::string& options,
                                     const job::Catalogue& catalogue);

}  // namespace planish::batch
