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

json file(const std::string& name, const std::string& content) {
  return {{"name", name}, {"content", content}};
}

/// A value of each option that is not its default.
json sample_of(const Option& option) {
  static const std::map<std::string_view, json> kSamples{
      {"body", "1"},
      {"bend_k", {{"B1", 0.2}}},
      {"rip_edges", "1"},
      {"weights", "stroke=2"},
      {"fix", "B2"},
      {"shop", file("s.json", R"({"name": "S", "materials": [{"name": "steel", "density": 8,
        "tensile_strength": 500, "gauges": [{"thickness": 2, "inside_radius": 3, "k": 0.3}]}],
        "dxf": {"layers": {"outer": "CUT"}}, "limits": {"most_bends": 1}})")},
      {"materials", file("m.csv", "part;material;density;quantity\n*;Steel;7;3\n")},
      {"material", file("x.json", R"({"name": "steel",
        "tension": {"power_law": {"strength": 500, "exponent": 0.2}},
        "compression": {"power_law": {"strength": 600, "exponent": 0.2}}})")},
      {"k_table", file("k.csv", "r/t,k\n0.1,0.25\n9,0.25\n")},
      {"rules", file("r.json", R"({"flange_height_t": 30})")},
      {"tools", file("t.json", std::string(shop::default_tools_json()))},
      {"root", "2"},
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

  json input() const {
    const json plates = {{"name", "channel.json"}, {"content", channel_plates_of_two_heights()}};
    if (maker().format == "planish/plates") return plates;
    if (maker().format == "planish/transition")
      return {{"name", "cone.json"},
              {"content", test::bytes_of_file(test::example("transition/a_square_to_round.json"))}};
    const auto made = test::done_by(
        {{"maker", "connect"}, {"input", plates}, {"artifacts", {"step"}}});
    EXPECT_EQ(made.artifacts.size(), 1u);
    return {{"name", "channel.step"}, {"content", made.artifacts.at(0).bytes}};
  }

  Came came_of(const json& input, const json& options) const {
    const auto done = shown(run(
        json{{"maker", GetParam()}, {"input", input}, {"options", options}, {"artifacts", {"dxf"}}}
            .dump()));
    if (!done) return {{}, done.error()};
    std::string text = done->report;
    for (const ArtifactFile& artifact : done->artifacts)
      text += artifact.bytes;
    return {text, std::nullopt};
  }

 private:
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

/// Of two, the one that has no effect beside the other, and why that is what it says.
bool covers(std::string_view covering, std::string_view covered) {
  static const std::set<std::pair<std::string_view, std::string_view>> kKnown{};
  return kKnown.contains({covering, covered});
}

TEST_P(OptionPairs, WorkTogetherOrAreRefusedByName) {
  const json what = input();
  const std::string plain = came_of(what, json::object()).text;
  ASSERT_FALSE(plain.empty());
  std::map<std::string_view, Came> alone;
  for (const OptionUse& use : maker().options)
    alone[use.name] = came_of(what, {{std::string(use.name), sample_of(use.entry())}});
  for (const OptionUse& first : maker().options)
    for (const OptionUse& second : maker().options) {
      if (&first >= &second) continue;
      const std::string a(first.name), b(second.name);
      const Came both = came_of(what,
                                {{a, sample_of(first.entry())}, {b, sample_of(second.entry())}});
      const Came &one = alone[first.name], &other = alone[second.name];
      if (both.error) {
        EXPECT_EQ(both.error->code, code::bad_option) << a << " " << b;
        const bool by_itself = (one.error && one.error->message == both.error->message) ||
                               (other.error && other.error->message == both.error->message);
        EXPECT_TRUE(by_itself || (names(*both.error, a) && names(*both.error, b)))
            << a << " " << b << ": " << both.error->message;
        continue;
      }
      if (one.error || other.error || one.text == plain || other.text == plain) continue;
      EXPECT_TRUE(both.text != one.text || covers(a, b)) << b << " does nothing beside " << a;
      EXPECT_TRUE(both.text != other.text || covers(b, a)) << a << " does nothing beside " << b;
    }
}

INSTANTIATE_TEST_SUITE_P(Makers, OptionPairs, ::testing::Values("unfold", "connect", "transition"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace planish::job
