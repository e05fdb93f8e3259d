#include "support/real_parts.hpp"
#include "support/sheets.hpp"

#include <planish/brep/step.hpp>
#include <planish/job/unfold.hpp>

#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <vector>

// What unfolding costs beside reading the file, part by part over the real parts, and how it grows
// with the number of flanges. Everything is a ratio within one run.

namespace {

namespace fs = std::filesystem;
using namespace planish;

const fs::path kParts = test::real_parts_folder();

std::vector<fs::path> parts() {
  std::vector<fs::path> files;
  if (fs::exists(kParts))
    for (const auto& entry : fs::directory_iterator(kParts))
      if (entry.path().extension() == ".step") files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values.empty()
             ? 0.0
             : values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// Everything but reading: recognition, flattening, certificate, overlap, rules, DXF text.
void unfold_all_of(const StepFile& file) {
  for (const Body& body : file.bodies) {
    const auto report = job::unfold_body(body, {});
    if (report) benchmark::DoNotOptimize(dxf_text(report->flat));
  }
}

void UnfoldAsShareOfReading(benchmark::State& state) {
  for (auto _ : state) {
    std::vector<double> shares;
    for (const fs::path& path : parts()) {
      const auto start = std::chrono::steady_clock::now();
      const auto file = read_step(path);
      const double reading = seconds_since(start);
      if (!file) continue;
      const auto middle = std::chrono::steady_clock::now();
      unfold_all_of(*file);
      shares.push_back(seconds_since(middle) / reading);
    }
    if (shares.empty()) return state.SkipWithError("no real parts beside the repository");
    state.counters["parts"] = static_cast<double>(shares.size());
    state.counters["median_percent"] = 100 * quantile(shares, 0.5);
    state.counters["p90_percent"] = 100 * quantile(shares, 0.9);
    state.counters["max_percent"] = 100 * quantile(shares, 1.0);
  }
}
BENCHMARK(UnfoldAsShareOfReading)->Iterations(1)->Unit(benchmark::kSecond);

/// Peak memory of a child process that reads a part, and unfolds it or not, in KiB.
double peak_memory(const fs::path& path, bool unfold) {
  const pid_t child = fork();
  if (child == 0) {
    const auto file = read_step(path);
    if (file && unfold) unfold_all_of(*file);
    _exit(0);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  return static_cast<double>(usage.ru_maxrss);
}

void PeakMemoryBesideReading(benchmark::State& state) {
  for (auto _ : state) {
    std::vector<double> ratios;
    const auto files = parts();
    for (size_t i = 0; i < files.size(); i += 10)  // every tenth: reading twice takes its time
      ratios.push_back(peak_memory(files[i], true) / peak_memory(files[i], false));
    if (ratios.empty()) return state.SkipWithError("no real parts beside the repository");
    state.counters["median_ratio"] = quantile(ratios, 0.5);
    state.counters["max_ratio"] = quantile(ratios, 1.0);
  }
}
BENCHMARK(PeakMemoryBesideReading)->Iterations(1)->Unit(benchmark::kSecond);

/// Growth with the number of flanges: recognition, flattening and certificate of a staircase.
void UnfoldStaircase(benchmark::State& state) {
  const int steps = static_cast<int>(state.range(0)) / 2;
  const auto text = folded_solid_step(test::staircase(steps), "staircase");
  const auto file = text ? read_step_text(*text, "staircase.step") : tl::unexpected(text.error());
  if (!file) return state.SkipWithError(file.error().message.c_str());
  for (auto _ : state) {
    const auto report = job::unfold_body(file->bodies.front(), {});
    if (!report) return state.SkipWithError("the staircase did not unfold");
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(UnfoldStaircase)
    ->Arg(10)
    ->Arg(100)
    ->Arg(300)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();

}  // namespace
