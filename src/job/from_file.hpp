#pragma once

#include <planish/job/maker.hpp>

#include <chrono>

namespace planish::job {

/// Reads the file of a request, parses it and makes the report, which records the time of both.
template <typename Parse, typename Make>
auto from_file(const Request& request, const std::string& kind, const Parse& parse,
               const Make& make, const Progress& progress)
    -> decltype(make(*parse(InputFile()), request, progress)) {
  const auto start = std::chrono::steady_clock::now();
  const auto input = read_input_file(request.input, kind);
  if (!input) return pass_on(input);
  const auto file = parse(*input);
  if (!file) return pass_on(file);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  auto report = shown(make(*file, request, progress));
  if (!report) return pass_on(report);
  report->read_seconds = taken.count();
  return std::move(*report);
}

}  // namespace planish::job
