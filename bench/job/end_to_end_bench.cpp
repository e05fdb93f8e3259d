#include "support/real_parts.hpp"

#include <planish/brep/step.hpp>
#include <planish/inspect/findings.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/sheet/certificate.hpp>

#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

// What somebody waits for from a STEP file to its DXF, stage by stage: over the real parts, and as
// the number of openings or flanges grows. `start` is the program without work; `program` is the
// whole program run on the file, the sum of all stages but for what it prints.

namespace {

namespace fs = std::filesystem;
using namespace planish;
using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Milliseconds by stage, in the order in which they are met.
using Stages = std::map<std::string, double>;

/// PLANISH_CLI, or the program of the same build.
fs::path program() {
  if (const char* given = std::getenv("PLANISH_CLI")) return given;
  return fs::read_symlink("/proc/self/exe").parent_path() / "apps/planish";
}

/// Time of the program with these arguments, its output thrown away.
double run_time(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), program().string());
  std::vector<char*> raw;
  for (std::string& argument : arguments)
    raw.push_back(argument.data());
  raw.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
  const auto start = Clock::now();
  pid_t child = 0;
  int status = -1;
  if (posix_spawn(&child, raw.front(), &actions, nullptr, raw.data(), environ) == 0)
    waitpid(child, &status, 0);
  posix_spawn_file_actions_destroy(&actions);
  return ms_since(start);
}

/// A folder of this process, gone with it.
class Scratch {
 public:
  Scratch() : path_(fs::temp_directory_path() / ("planish-bench-" + std::to_string(getpid()))) {
    fs::create_directories(path_);
  }
  ~Scratch() { fs::remove_all(path_); }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

const fs::path& scratch() {
  static const Scratch folder;
  return folder.path();
}

Result<StepFile> read_in_stages(const fs::path& path, Stages& stages) {
  auto began = Clock::now();
  std::string stage = "parse";
  Progress progress;
  progress.report = [&](std::string_view name, double) {
    if (stage != "parse" || name != "translating") return;
    stages[stage] += ms_since(began);
    began = Clock::now();
    stage = "transfer";
  };
  auto file = read_step(path, progress);
  stages[stage] += ms_since(began);
  return file;
}

/// What `planish unfold` does with the first body of a file; false when that has no pattern.
bool unfold_in_stages(const fs::path& path, Stages& stages) {
  const auto file = read_in_stages(path, stages);
  if (!file) return false;
  auto began = Clock::now();
  const auto ended = [&](const char* stage) {
    stages[stage] += ms_since(began);
    began = Clock::now();
  };
  const auto found = recognize(file->bodies.front());
  ended("recognise");
  if (!found) return false;
  const auto flat = flat_sheet(found->sheet);
  ended("flatten");
  if (!flat) return false;
  const auto certificate = certify(found->sheet, flat->pattern, found->distance);
  ended("certify");
  if (!certificate) return false;
  benchmark::DoNotOptimize(find_overlaps(found->sheet, flat->layout, flat->pattern));
  benchmark::DoNotOptimize(check_rules(found->sheet, flat->pattern, {}));
  ended("inspect");
  const auto text = dxf_text(flat->pattern);
  if (!text || !write_file(scratch() / "bench.dxf", *text)) return false;
  ended("write");
  return true;
}

double start_time() {
  std::vector<double> times;
  for (int i = 0; i < 15; ++i)
    times.push_back(run_time({"--version"}));
  return median(times);
}

double program_time(const fs::path& path) {
  return run_time({"unfold", path.string(), "-o", (scratch() / "program.dxf").string()});
}

std::vector<fs::path> real_parts() {
  std::vector<fs::path> files;
  const fs::path folder = test::real_parts_folder();
  if (fs::exists(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".step") files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

/// Medians over the real parts, each stage by itself.
void EndToEndRealParts(benchmark::State& state) {
  const std::vector<fs::path> parts = real_parts();
  if (parts.empty()) return state.SkipWithError(test::kNoRealParts);
  for (auto _ : state) {
    std::map<std::string, std::vector<double>> times;
    for (const fs::path& part : parts) {
      Stages stages;
      unfold_in_stages(part, stages);
      for (const auto& [stage, time] : stages)
        times[stage].push_back(time);
      times["program"].push_back(program_time(part));
    }
    for (const auto& [stage, all] : times)
      state.counters[stage + "_ms"] = median(all);
    state.counters["start_ms"] = start_time();
  }
}
BENCHMARK(EndToEndRealParts)->Iterations(1)->Unit(benchmark::kSecond);

/// Parts of bench/make_growth_parts.py, made once.
fs::path growth_part(const char* kind, std::int64_t count) {
  static const int made = std::system(
      ("/usr/bin/python3 " PLANISH_SOURCE_DIR "/bench/make_growth_parts.py " + scratch().string())
          .c_str());
  return made == 0 ? scratch() / (kind + ("-" + std::to_string(count)) + ".step") : fs::path();
}

void grow(benchmark::State& state, const char* kind) {
  const fs::path part = growth_part(kind, state.range(0));
  Stages stages;
  for (auto _ : state)
    if (!unfold_in_stages(part, stages)) return state.SkipWithError("the part does not unfold");
  for (const auto& [stage, time] : stages)
    state.counters[stage + "_ms"] = time / static_cast<double>(state.iterations());
  state.counters["program_ms"] = program_time(part);
  state.SetComplexityN(state.range(0));
}

void EndToEndHoles(benchmark::State& state) { grow(state, "holes"); }
void EndToEndSlots(benchmark::State& state) { grow(state, "slots"); }
void EndToEndStairs(benchmark::State& state) { grow(state, "stairs"); }
void EndToEndFolds(benchmark::State& state) { grow(state, "folds"); }

void openings(benchmark::internal::Benchmark* bench) {
  bench->Arg(100)->Arg(1000)->Arg(3000)->Arg(10000)->Unit(benchmark::kMillisecond)->Complexity();
}
void flanges(benchmark::internal::Benchmark* bench) {
  bench->Arg(10)->Arg(100)->Arg(300)->Arg(1000)->Arg(3000)->Unit(benchmark::kMillisecond);
  bench->Complexity();
}
BENCHMARK(EndToEndHoles)->Apply(openings);
BENCHMARK(EndToEndSlots)->Apply(openings);
BENCHMARK(EndToEndStairs)->Apply(flanges);
BENCHMARK(EndToEndFolds)->Apply(flanges);

}  // namespace
