#pragma once

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace planish::test {

/// What a program that makes random inputs is asked for.
struct RandomRun {
  std::uint64_t seed = 1;
  int count = 0, first = 0;
  std::string keep;  ///< folder for the files of what is wrong; empty: none
  bool list = false;
};

inline constexpr auto
    kRandomRunUsage = "[--seed N] [--count N] [--first N] [--keep FOLDER] [--list]";

/// Reads the words of a command line; empty if it is none.
inline std::optional<RandomRun> random_run(const std::vector<std::string>& words, int count) {
  RandomRun run;
  run.count = count;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--list") {
      run.list = true;
      continue;
    }
    if (i + 1 == words.size()) return std::nullopt;
    const std::string &name = words[i], &value = words[++i];
    if (name == "--seed")
      run.seed = std::strtoull(value.c_str(), nullptr, 10);
    else if (name == "--count")
      run.count = std::atoi(value.c_str());
    else if (name == "--first")
      run.first = std::atoi(value.c_str());
    else if (name == "--keep")
      run.keep = value;
    else
      return std::nullopt;
  }
  return run;
}

}  // namespace planish::test
