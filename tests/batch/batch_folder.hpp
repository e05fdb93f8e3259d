#pragma once

#include "part_work.hpp"
#include "results.hpp"
#include "state.hpp"
#include "support/flat_plate.hpp"
#include "support/test_folder.hpp"

#include <planish/io/flat_json.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace planish::test {

/// A folder of one test, gone when it ends.
class BatchFolder : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const { own_.write(name, text); }
  std::string text_in(const std::string& name) const { return own_.read(name); }

 private:
  const TestFolder own_;

 protected:
  const std::filesystem::path& folder_ = own_.path();
};

/// A part that was made, with one file.
inline batch::PartDone made_part(const std::string& input, const FlatPattern& flat) {
  const nlohmann::json report{{"input", input},
                              {"body", input},
                              {"quantity", 1},
                              {"status", "ok"},
                              {"reason", nullptr},
                              {"units", "mm"},
                              {"checks", nlohmann::json::array()},
                              {"files", {input + "/a.dxf"}}};
  return batch::part_done(input, report.dump(), {flat_json(flat)}, {{"a.dxf", "dxf of " + input}});
}

inline batch::PartDone refused_part(const std::string& input, const std::string& code) {
  const nlohmann::json report{
      {"input", input}, {"status", "refused"}, {"reason", {{"code", code}, {"message", "m"}}}};
  return batch::part_done(input, report.dump(), {}, {});
}

/// A folder with results of finished runs.
class RunFolder : public BatchFolder {
 protected:
  /// Results of inputs each of which is a plate, but "r", which was refused.
  void run(const std::string& out, batch::Shard shard, const std::vector<std::string>& names,
           bool finished = true, const std::string& work = "work") const {
    auto state = batch::State::open(folder_ / out);
    ASSERT_TRUE(state);
    for (const std::string& name : names) {
      const batch::PartDone part = name == "r" ? refused_part(name, "overlap")
                                               : made_part(name, flat_plate(100, 10 * name[0]));
      ASSERT_TRUE(state->store({part}, {}));
      ASSERT_TRUE(state->journal().add(name, "key of " + name, {part}));
    }
    if (finished) {
      ASSERT_TRUE(batch::write_results({.names = names}, *state));
    }
    ASSERT_TRUE(state->record({shard, 4, work, finished, names, {}, {}}));
  }
};

}  // namespace planish::test
