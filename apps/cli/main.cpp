#include "program.hpp"
#include "terminal.hpp"

int main(int argc, char** argv) {
  planish::cli::stop_on_interrupt();
  return planish::cli::run_program(argc, argv, planish::job::built_in());
}
