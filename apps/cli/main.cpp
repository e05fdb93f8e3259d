#include "program.hpp"
#include "terminal.hpp"

#include <cstdlib>

int main(int argc, char** argv) {
  planish::cli::stop_on_interrupt();
  // Everything is written and flushed: half a hundred libraries need not be taken down one by one.
  std::_Exit(planish::cli::run_program(argc, argv, planish::job::built_in()));
}
