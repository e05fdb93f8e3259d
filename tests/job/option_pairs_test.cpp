#include "job/job_requests.hpp"

#include <planish/job/options.hpp>
#include <planish/shop/tools_json.hpp>

#include <gtest/gtest.h>

#include <map>
#include <set>

// All pairs of options that a maker has, from its own table. Two either work together, so each of
// them changes what comes out beside the other as it does alone, or the request is refused and says
// which two. None may be taken and have no effect.

namespace planish::job {
namespace {

using nlohmann::json;

json file(const std::string& name, const json& content) {
  return {{"name", name}, {"content", content}};
}

constexpr std::string_view kBends = "check_bending";

/// A value of each option that is not its default.
json sample_of(const Option& option) {
  static const std::map<std::string_view, json> kSamples{
      {"body", "1"},
      {"bend_k", {{"B1", 0.2}}},
      {"rip_edges", "1"},
      {"weights", "stroke=2"},
      {"fix", "B2"},
      {"shop",
       file("s.json", json::parse(R"({"name": "S", "materials": [{"name": "steel", "density": 8,
        "tensile_strength": 500, "gauges": [{"thickness": 2, "inside_radius": 3, "k": 0.3}]}],
        "dxf": {"layers": {"outer": "CUT"}}, "limits": {"most_bends": 1}})"))},
      {"materials", file("m.csv", "part;material;quantity\n*;Steel;3\n")},
      {"material", file("x.json", json::parse(R"({"name": "steel",
        "tension": {"power_law": {"strength": 500, "exponent": 0.2}},
        "compression": {"power_law": {"strength": 600, "exponent": 0.2}}})"))},
      {"k_table", file("k.csv", "r/t,k\n0.1,0.25\n9,0.25\n")},
      {"rules", file("r.json", json::parse(R"({"flange_height_t": 30})"))},
      {"tools", file("t.json", std::string(shop::default_tools_json()))},
      {"piece", 0},
      {"thickness", 2},
      {"largest_span", 500},
      {"up", "other"}};
  if (const auto own = kSamples.find(option.name); own != kSamples.end()) return own->second;
  switch (option.kind) {
    case OptionKind::flag:
      return true;
    case OptionKind::whole:
      return 1;
    case OptionKind::number:
      return 0.5;
    case OptionKind::word:
    case OptionKind::face:
      return std::string(option.words.back());
    default:
      ADD_FAILURE() << "give a sample of " << option.name;
      return nullptr;
  }
}

/// What comes of options: the report and the pattern, or the error.
struct Came {
  std::string text;
  std::optional<Error> error;
};

class OptionPairs : public ::testing::TestWithParam<const char*> {
 protected:
  const Maker& maker() const { return *built_in().maker(GetParam()); }

  /// Curves to be pressed line by line take long to plan, and so do proposals for what cannot be
  /// bent: what is bent is a roof flat enough.
  json input(bool bent) const {
    const json plates = {{"name", "channel.json"}, {"content", channel_plates_of_two_heights()}};
    if (maker().format == "planish/plates") return plates;
    if (maker().format == "planish/transition")
      return {
          {"name", "transition.json"},
          {"content",
           bent ? flat_roof()
                : json(test::bytes_of_file(test::example("transition/a_square_to_round.json")))}};
    const auto made = test::done_by(
        {{"maker", "connect"}, {"input", plates}, {"artifacts", {"step"}}});
    EXPECT_EQ(made.artifacts.size(), 1u);
    return {{"name", "channel.step"}, {"content", made.artifacts.at(0).bytes}};
  }

  Came came_of(const json& what, const json& options) const {
    const auto done = shown(run(
        json{{"maker", GetParam()}, {"input", what}, {"options", options}, {"artifacts", {"dxf"}}}
            .dump()));
    if (!done) return {{}, done.error()};
    std::string text = done->report;
    for (const ArtifactFile& artifact : done->artifacts)
      text += artifact.bytes;
    return {text, std::nullopt};
  }

 private:
  static json flat_roof() {
    return json::parse(R"({"format": "planish/transition", "version": 1, "units": "mm",
      "thickness": 1, "to": {"profile": {"polygon": [[-80, 0], [80, 0]]},
                             "frame": {"origin": [0, 0, 60]}},
      "from": {"profile": {"polygon": [[-200, -120], [200, -120], [200, 120], [-200, 120]]}}})");
  }
  static json channel_plates_of_two_heights() {
    json plates = test::channel_plates(40);
    plates["plates"][2]["outline"][2][2] = 50;
    plates["plates"][2]["outline"][3][2] = 50;
    return plates;
  }
};

bool names(const Error& error, std::string_view option) {
  return error.message.find(std::string("`") + std::string(option) + "`") != std::string::npos;
}

/// What comes of no options and of each by itself.
struct Alone {
  json input;
  std::string plain;
  std::map<std::string_view, Came> of;
};

TEST_P(OptionPairs, WorkTogetherOrAreRefusedByName) {
  std::map<std::string_view, json> samples;
  for (const OptionUse& use : maker().options)
    samples[use.name] = sample_of(use.entry());
  std::map<bool, Alone> alone;
  for (const bool bent : {false, true}) {
    Alone& one = alone[bent];
    one.input = input(bent);
    one.plain = came_of(one.input, json::object()).text;
    ASSERT_FALSE(one.plain.empty());
  }
  // Another face that may stay where it is.
  for (int face = 1; samples.contains("root") && face < 30; ++face) {
    const Came came = came_of(alone[false].input, {{"root", std::to_string(face)}});
    if (!came.error && came.text != alone[false].plain) samples["root"] = std::to_string(face);
  }
  for (auto& [bent, one] : alone)
    for (const OptionUse& use : maker().options) {
      if (use.name == kBends && !bent) continue;
      one.of[use.name] = came_of(one.input, {{std::string(use.name), samples[use.name]}});
      const std::set<std::string_view> refused{"rip_edges", "tick_length", "material"};
      EXPECT_TRUE(!one.of[use.name].error || refused.contains(use.name))
          << use.name << ": " << one.of[use.name].error->message;
    }
  for (const OptionUse& first : maker().options)
    for (const OptionUse& second : maker().options) {
      if (&first >= &second) continue;
      const std::string a(first.name), b(second.name);
      const Alone& apart = alone[a == kBends || b == kBends];
      const Came both = came_of(apart.input, {{a, samples[first.name]}, {b, samples[second.name]}});
      const Came &one = apart.of.at(first.name), &other = apart.of.at(second.name);
      if (one.error || other.error) continue;
      if (both.error) {
        EXPECT_EQ(both.error->code, code::bad_option) << a << " " << b;
        EXPECT_TRUE(names(*both.error, a) && names(*both.error, b)) << both.error->message;
        continue;
      }
      if (one.text == apart.plain || other.text == apart.plain) continue;
      EXPECT_TRUE(both.text != one.text) << b << " does nothing beside " << a;
      EXPECT_TRUE(both.text != other.text) << a << " does nothing beside " << b;
    }
}

INSTANTIATE_TEST_SUITE_P(Makers, OptionPairs, ::testing::Values("unfold", "connect", "transition"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace
}  // namespace planish::job
