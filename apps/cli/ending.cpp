#include "ending.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace planish::cli {

void print_summary(const PatternArguments& arguments, const std::string& text) {
  if (arguments.quiet) return;
  std::FILE* stream = arguments.json == "-" ? stderr : stdout;
  fmt::print(stream, "{}", text);
}

int end_failed(const PatternArguments& arguments, const Error& error, const std::string& json) {
  const int status = complain(error);
  if (error.code == ErrorCode::cancelled) return status;
  if (const auto unwritten = write_report(arguments.json, json)) complain(*unwritten);
  return status;
}

int end_unplanned(const PatternArguments& arguments, const Error& error, const std::string& json) {
  if (error.code != ErrorCode::cannot_read && error.code != ErrorCode::invalid_input) {
    return complain(error);
  }
  return end_failed(arguments, error, json);
}

}  // namespace planish::cli
