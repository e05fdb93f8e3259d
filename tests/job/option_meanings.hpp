#pragma once

#include <planish/job/options.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace planish::test {

/// A request with one option, given as on a command line.
inline job::Request with_text(const char* name, const char* text) {
  job::OptionValues values;
  const auto set = values.set_text(job::option(name), text);
  EXPECT_TRUE(set) << name << " " << text;
  job::Request request;
  const auto entered = values.enter(request);
  EXPECT_TRUE(entered) << name << " " << text;
  return request;
}

/// What a request says once the option has the value.
struct Meaning {
  const char *name, *text;
  std::function<bool(const job::Request&)> holds;
};

inline void expect_meanings(const std::vector<Meaning>& meanings) {
  for (const Meaning& one : meanings)
    EXPECT_TRUE(one.holds(with_text(one.name, one.text))) << one.name << " " << one.text;
}

}  // namespace planish::test
