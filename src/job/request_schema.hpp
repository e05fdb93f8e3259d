#pragma once

#include <planish/job/artifact.hpp>
#include <planish/job/run.hpp>
#include <planish/schema/schema.hpp>

namespace planish::job {

/// An object with the options that several makers share and this one's own; null is the same as
/// leaving an option out.
schema::Schema options_schema(OptionFiles files, const Maker& maker);
/// A request to `run`.
schema::Schema request_schema(const Catalogue& catalogue);
/// The same without "maker", of one task or maker: with its own options and artifacts.
schema::Schema request_schema(const std::string& name, const Catalogue& catalogue);

/// The values in an "options" object that `options_schema` of the maker has checked.
OptionValues values_of(const schema::Json& options, const Maker& maker);

}  // namespace planish::job
