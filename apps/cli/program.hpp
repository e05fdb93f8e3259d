#pragma once

#include <planish/job/artifact.hpp>

namespace planish::cli {

/// The program `planish` with the makers and artifacts of a catalogue; returns the exit status.
/// An exception becomes an internal error.
int run_program(int argc, const char* const* argv, const job::Catalogue& catalogue);

}  // namespace planish::cli
