#pragma once

#include "document_store.hpp"

#include <filesystem>

namespace planish::studio {

/// Opens the file that the user named, with the files beside it that a slit file refers to. Errors:
/// `cannot_read`, and those of the worker.
Result<void> open_first(DocumentStore& store, const std::filesystem::path& file);

}  // namespace planish::studio
