#include "job/planned_reports.hpp"

#include <planish/job/artifact.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace planish::job {
namespace {

using ::testing::HasSubstr;
using json = nlohmann::json;

TEST(Catalogue, HasWhatEveryRowNeeds) {
  for (const Maker& maker : built_in().makers) {
    EXPECT_TRUE(maker.open && maker.failed) << maker.name;
    EXPECT_EQ(maker.schema == nullptr, maker.format.empty()) << maker.name;
    for (const OptionUse& use : maker.options)
      EXPECT_TRUE(option(use.name).set) << use.name;
    const auto failed = maker.failed({}, {code::cannot_read, "gone", "a"});
    EXPECT_EQ(json::parse(failed->json())["reason"]["code"], "cannot_read") << maker.name;
    EXPECT_EQ(json::parse(failed->json())["command"], maker.name);
  }
  for (const Artifact& artifact : built_in().artifacts)
    EXPECT_TRUE(artifact.write) << artifact.name;
}

TEST(Catalogue, KnowsAnInputByItsFormatElseByItsMark) {
  for (const Maker& maker : built_in().makers) {
    if (maker.format.empty()) continue;
    for (const char* key : {"format", ""}) {
      json document{{std::string(maker.mark), 1}};
      if (*key) document = {{"format", maker.format}};
      const auto found = built_in().maker_for("a.json", document.dump());
      ASSERT_TRUE(found.has_value()) << found.error().message;
      EXPECT_EQ((*found)->name, maker.name);
    }
  }
  EXPECT_EQ((*built_in().maker_for("a.step", "ISO-10303-21;"))->name, "unfold");
  EXPECT_THAT(built_in().maker_for("a.json", R"({"format": "x"})").error().message,
              HasSubstr("planish/plates, planish/transition, planish/slits"));
  const std::string long_format = R"({"format": ")" + std::string(3000, 'x') + R"("})";
  EXPECT_LT(built_in().maker_for("a.json", long_format).error().message.size(), 300u);
  EXPECT_THAT(built_in().maker_for("a.json", "{}").error().message,
              HasSubstr("plates file, transition file, slit file"));
}

TEST(Catalogue, FindsWhatAMakerWrites) {
  const Maker &unfolding = *built_in().maker("unfold"), &joining = *built_in().maker("connect");
  EXPECT_EQ(built_in().maker("fold"), nullptr);
  EXPECT_EQ(built_in().artifact(joining, "step")->role, Role::folded);
  EXPECT_EQ(built_in().artifact(unfolding, "step")->role, Role::flat);
  EXPECT_EQ(built_in().artifact(joining, "flat.step")->role, Role::flat);
  EXPECT_EQ(built_in().artifact(joining, "mould.stl"), nullptr);
  EXPECT_EQ(built_in().artifact(joining, ""), nullptr);
  for (const Role role : {Role::flat, Role::folded, Role::mould, Role::report}) {
    const auto written = built_in().written_by(joining, role);
    EXPECT_EQ(written.empty(), role == Role::mould);
    for (const Artifact* one : written)
      EXPECT_EQ(one->role, role);
  }
}

TEST(Catalogue, KnowsNoOtherInputs) {
  for (const char* content : {"{}", "[]", "{", R"({"format": "planish/other"})"}) {
    const auto found = built_in().maker_for("a.json", content);
    ASSERT_FALSE(found) << content;
    EXPECT_EQ(found.error().code, code::invalid_input);
    EXPECT_EQ(found.error().where.rfind("a.json", 0), 0u);
  }
  EXPECT_EQ((*built_in().maker_for("a", " \n\t{\"plates\": []}"))->name, "connect");
  EXPECT_EQ((*built_in().maker_for("a", "\xEF\xBB\xBFISO-10303-21;"))->name, "unfold");
  EXPECT_EQ((*built_in().maker_for("a", ""))->name, "unfold") << "whatever is no JSON";
  EXPECT_EQ(built_in().maker_for("a", R"({"format": "x"})").error().where, "a/format");
  EXPECT_EQ((*built_in().maker_for("a", R"({"format": 3, "plates": 1})"))->name, "connect");
}

TEST(Maker, SaysWhatItTakesAndMakes) {
  const Maker& joining = *built_in().maker("connect");
  EXPECT_TRUE(joining.makes(Source::report)) << "as every maker";
  EXPECT_TRUE(joining.makes(Source::folded_solid));
  EXPECT_FALSE(joining.makes(Source::mould_mesh));
  EXPECT_TRUE(joining.takes("trade_off"));
  EXPECT_FALSE(joining.takes("rip_edges"));
  EXPECT_EQ(joining.input_kind(), "plates file");
  EXPECT_EQ(joining.schema_name(), "plates");
}

class TwoPieces : public Made {
 public:
  const Report& report() const override { return report_; }
  Report& report() override { return report_; }
  std::string json() const override { return "{}"; }
  std::string text() const override { return ""; }
  int pieces() const override { return 2; }
  const Report& piece(int i) const override { return i == 0 ? report_ : second_; }

 private:
  Report report_ = test::sample_report(), second_ = test::sample_report();
};

TEST(Made, ShowsThePieceThatIsAskedFor) {
  TwoPieces made;
  EXPECT_EQ(*piece_of(made, 0), &made.report());
  EXPECT_EQ(*piece_of(made, 1), &made.piece(1));
  const auto none = piece_of(made, 2);
  EXPECT_EQ(none.error().code, code::bad_option);
  EXPECT_EQ(none.error().where, "piece");
  made.report().refusal = Error{code::cannot_read, "m", ""};
  EXPECT_EQ(*piece_of(made, 2), &made.report()) << "a refusal may have left none";
}

TEST(Made, MakesNothingThatItsMakerDoesNot) {
  const TwoPieces made;
  EXPECT_EQ(made.folded_solid(0).error().code, code::bad_option);
  EXPECT_EQ(made.folded_mesh().error().code, code::bad_option);
  EXPECT_EQ(made.mould_mesh().error().code, code::bad_option);
  EXPECT_EQ(made.handles(), "{}");
}

TEST(InputFile, KnowsItsFolderAndItsName) {
  const std::string path = PLANISH_SOURCE_DIR "/examples/transition/e_reducer.json";
  const auto file = read_input_file(path, "transition file");
  ASSERT_TRUE(file);
  EXPECT_EQ(file->name, path);
  EXPECT_EQ(file->folder, PLANISH_SOURCE_DIR "/examples/transition");
  EXPECT_EQ(read_input_file("/no/such", "plates file").error().code, code::cannot_read);
  Request request;
  request.input = path;
  const Maker& maker = *built_in().maker("transition");
  EXPECT_TRUE(open_input(maker, request, {}));
  Progress progress;
  progress.cancelled = [] { return true; };
  EXPECT_EQ(open_input(maker, request, progress).error().code, code::cancelled);
  request.input = "/no/such";
  EXPECT_EQ(open_input(maker, request, {}).error().code, code::cannot_read);
}

}  // namespace
}  // namespace planish::job
