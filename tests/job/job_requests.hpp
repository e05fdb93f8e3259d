#pragma once

#include <planish/job/artifact.hpp>
#include <planish/job/run.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <string>

namespace planish::test {

inline std::string example(const std::string& name) {
  return PLANISH_SOURCE_DIR "/examples/" + name;
}

inline std::string bytes_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A channel of 2 mm as plates that leave room for the bends: a web of 60 mm and legs of a given
/// height, measured to where the plates meet, 100 mm long.
inline nlohmann::json channel_plates(double leg) {
  const double room = 5.0;
  const auto upright = [&](double x) {
    return nlohmann::json{{x, 0, room}, {x, 100, room}, {x, 100, leg}, {x, 0, leg}};
  };
  nlohmann::json plates;
  plates["thickness"] = 2;
  plates["defaults"]["inside_radius"] = 2;
  plates["plates"] = {
      {{"id", "web"},
       {"outline", {{room, 0, 0}, {60 - room, 0, 0}, {60 - room, 100, 0}, {room, 100, 0}}}},
      {{"id", "left"}, {"outline", upright(0)}},
      {{"id", "right"}, {"outline", upright(60)}}};
  plates["bends"] = {{{"between", {"web", "left"}}}, {{"between", {"web", "right"}}}};
  return plates;
}

/// What the maker of an input makes of it, refused or not; fails, and is null, if it makes nothing.
inline std::unique_ptr<job::Made> made_from(const std::string& name, const std::string& content,
                                            job::Request request = {}) {
  request.input = name;
  const auto maker = job::built_in().maker_for(name, content);
  if (!maker) return ADD_FAILURE() << maker.error().message, nullptr;
  const auto work = (*maker)->open({name, content, {}}, {});
  if (!work) return ADD_FAILURE() << work.error().message, nullptr;
  auto made = shown((*work)->make(request, {}));
  if (!made) return ADD_FAILURE() << made.error().message, nullptr;
  return std::move(*made);
}

/// The draft of a square-to-round in two pieces.
inline std::unique_ptr<job::Made> made_in_two_pieces() {
  job::Request request;
  request.effort = job::Effort::draft;
  auto net = nlohmann::json::parse(bytes_of_file(example("transition/a_square_to_round.json")));
  net["pieces"] = 2;
  return made_from("net.json", net.dump(), request);
}

/// What comes of a request that is met, or that is refused and has a report all the same.
inline job::RunResult done_by(const nlohmann::json& asked) {
  const auto done = shown(job::run(asked.dump()));
  EXPECT_TRUE(done) << (done ? "" : done.error().message);
  return done.value_or(job::RunResult{});
}

/// The error of one that is not.
inline Error error_by(const nlohmann::json& asked) {
  const auto done = job::run(asked.dump());
  EXPECT_FALSE(done.has_value()) << asked;
  return done ? Error{} : Error(done.error());
}

}  // namespace planish::test
