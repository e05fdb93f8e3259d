#include "asked.hpp"

#include "job/job_requests.hpp"

#include <gtest/gtest.h>

namespace planish::job {
namespace {

using nlohmann::json;

const json kChannel{{"name", "channel.json"}, {"content", test::channel_plates(30)}};

Asked asked_by(const json& request, std::optional<std::string> bytes = {}) {
  auto asked = read_asked(request.dump(), built_in(), std::move(bytes));
  EXPECT_TRUE(asked) << (asked ? "" : asked.error().message);
  return asked ? std::move(*asked) : Asked{};
}

Error refused_by(const json& request) {
  const auto asked = read_asked(request.dump(), built_in());
  EXPECT_FALSE(asked) << request;
  return asked ? Error{} : asked.error();
}

TEST(Asked, HasTheMakerAndItsInput) {
  const Asked file = asked_by({{"maker", "connect"}, {"input", "no/such.json"}});
  EXPECT_EQ(file.task, built_in().task("connect"));
  EXPECT_EQ(file.task->reader, Reader::named);
  EXPECT_EQ(file.maker, built_in().maker("connect"));
  EXPECT_EQ(file.request.input, "no/such.json");
  EXPECT_FALSE(file.content) << "not read yet";
  EXPECT_EQ(file.request.effort, Effort::full);
  const Asked content = asked_by({{"maker", "connect"}, {"input", kChannel}, {"effort", "draft"}});
  EXPECT_EQ(content.request.input, "channel.json");
  EXPECT_EQ(json::parse(content.content->content), kChannel["content"]);
  EXPECT_FALSE(content.content->folder);
  EXPECT_EQ(content.request.effort, Effort::draft);
  const Asked unnamed = asked_by(
      {{"maker", "unfold"}, {"input", {{"content", "text"}, {"folder", "shop"}}}});
  EXPECT_EQ(unnamed.request.input, "input");
  EXPECT_EQ(unnamed.content->content, "text");
  EXPECT_EQ(unnamed.content->folder, "shop");
}

TEST(Asked, TakesBytesInPlaceOfAContent) {
  const Asked asked = asked_by(
      {{"maker", "unfold"}, {"input", {{"name", "a.step"}, {"content", "x"}}}},
      std::string("\xFF\0y", 3));
  EXPECT_EQ(asked.content->content, std::string("\xFF\0y", 3));
  EXPECT_FALSE(asked_by({{"maker", "unfold"}, {"input", "a.step"}}, "y").content);
}

TEST(Asked, ReadsWhatIsToBeBentForItsMaker) {
  const Asked bent = asked_by({{"maker", "bend"}, {"input", kChannel}, {"effort", "draft"}});
  EXPECT_EQ(bent.task, built_in().task("bend"));
  EXPECT_EQ(bent.maker, built_in().maker("connect"));
  EXPECT_EQ(bent.request.effort, Effort::full) << "a draft has no plan";
  EXPECT_EQ(bent.request.bending.ask, Bending::Ask::plan);
  const Asked of_file = asked_by({{"maker", "bend"}, {"input", test::example("bracket.step")}});
  EXPECT_EQ(of_file.maker, built_in().maker("unfold"));
  EXPECT_FALSE(of_file.content->content.empty());
  EXPECT_EQ(refused_by({{"maker", "bend"}, {"input", "/no/such"}}).code, code::cannot_read);
  EXPECT_EQ(asked_by({{"maker", "connect"}, {"input", kChannel}}).request.bending.ask,
            Bending::Ask::nothing);
}

TEST(Asked, InformsWithoutAMaker) {
  const Asked info = asked_by({{"maker", "info"}, {"input", "a.step"}, {"sheets", true}});
  EXPECT_EQ(info.task, built_in().task("info"));
  EXPECT_EQ(info.maker, nullptr);
  EXPECT_EQ(info.flags, std::vector<std::string_view>{"sheets"});
  EXPECT_EQ(refused_by({{"maker", "unfold"}, {"input", "a.step"}, {"sheets", true}}).where,
            "/sheets");
  EXPECT_TRUE(
      asked_by({{"maker", "unfold"}, {"input", "a.step"}, {"sheets", false}}).flags.empty());
}

TEST(Asked, FindsArtifactsByNameAndSuffix) {
  const Asked asked = asked_by(
      {{"maker", "unfold"}, {"input", "a"}, {"artifacts", {"json", "dxf"}}});
  ASSERT_EQ(asked.artifacts.size(), 2u);
  EXPECT_EQ(asked.artifacts[0]->name, "json");
  EXPECT_EQ(asked.artifacts[1]->name, "dxf");
  EXPECT_EQ(
      asked_by({{"maker", "unfold"}, {"input", "a"}, {"artifacts", {"step"}}}).artifacts[0]->name,
      "flat.step")
      << "unfold writes no folded one";
}

TEST(Asked, EntersOptionsAtTheirPointer) {
  json request{{"maker", "unfold"},
               {"input", "a"},
               {"options", {{"k", 0.3}, {"root", nullptr}, {"inside_radius", nullptr}}}};
  EXPECT_EQ(std::get<ConstantK>(*asked_by(request).request.allowance).k, 0.3);
  request["options"] = {{"inside_radius", 2}};
  EXPECT_EQ(refused_by(request).where, "/options/inside_radius");
  request["options"] = {{"k", 7}};
  Error error = refused_by(request);
  EXPECT_EQ(error.where, "/options/k");
  EXPECT_EQ(error.places, std::vector<Place>{place::pointer("/options/k")});
  request["options"] = {{"k", 0.3}, {"din6935", true}};
  EXPECT_EQ(refused_by(request).where, "/options/din6935");
}

TEST(Asked, AsksForTheFolderOfFilesThatAnInputNames) {
  json slit = json::parse(test::bytes_of_file(test::example("slit/chair.json")));
  json request{{"maker", "slit"}, {"input", {{"name", "s.json"}, {"content", slit}}}};
  EXPECT_FALSE(asked_by(request).content->folder) << "it names none";
  request["input"]["content"]["scan"] = {{{"strip", 0}, {"points", "a.xyz"}}};
  EXPECT_EQ(refused_by(request).where, "/input/folder");
  request["input"]["folder"] = "shop";
  EXPECT_EQ(asked_by(request).content->folder, "shop");
}

TEST(Asked, MakesWhatIsAsked) {
  Asked asked = asked_by({{"maker", "connect"}, {"input", kChannel}, {"effort", "draft"}});
  const auto made = make_asked(asked, {});
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ((*made)->report().flat.bends.size(), 2u);
  EXPECT_EQ((*made)->report().task, "") << "the maker's own";
  asked.request.piece = 1;
  EXPECT_EQ(make_asked(asked, {}).error().where, "piece");
  const auto absent = make_asked(asked_by({{"maker", "connect"}, {"input", "/no/such"}}), {});
  EXPECT_EQ(absent.error().code, code::cannot_read);
}

TEST(ReadOptions, TakesAnObjectOfTheMakersOptions) {
  const Maker& unfolding = *built_in().maker("unfold");
  const auto read = [&](const char* text, OptionFiles files = OptionFiles::content) {
    return read_options(text, unfolding, files, "/o");
  };
  EXPECT_EQ(read(R"({"k": 0.25})")->number("k"), 0.25);
  EXPECT_EQ(read("{").error().where, "/o");
  EXPECT_EQ(read("[]").error().code, code::invalid_input);
  EXPECT_EQ(read(R"({"k_table": "steel.csv"})").error().where, "/o/k_table");
  EXPECT_TRUE(read(R"({"k_table": "steel.csv"})", OptionFiles::path_or_content));
  EXPECT_EQ(read(R"({"trade_off": 1})").error().where, "/o/trade_off");
}

}  // namespace
}  // namespace planish::job
