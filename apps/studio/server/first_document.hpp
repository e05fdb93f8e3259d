#pragma once

#include "document_store.hpp"

#include <filesystem>

namespace planish::studio {

/// Opens the file that the user named, with the files beside it that a slit file names. Errors:
/// `cannot_read`, and what the worker says of it.
Result<void> open_first(DocumentStore& store, const std::filesystem::path& file);

}  // namespace planish::studio
