#include "job/job_requests.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace planish::job {
namespace {

using ::testing::StartsWith;

/// An angle of two plates, made whole.
const Made& joined_angle() {
  static const auto made = test::made_from("angle.json", R"({"thickness": 2,
      "defaults": {"inside_radius": 2}, "bends": [{"between": ["a", "b"]}], "plates": [
      {"id": "a", "outline": [[5, 0, 0], [60, 0, 0], [60, 40, 0], [5, 40, 0]]},
      {"id": "b", "outline": [[0, 0, 5], [0, 40, 5], [0, 40, 30], [0, 0, 30]]}]})");
  return *made;
}

std::string bytes_of(const char* name, const Request& request = {}) {
  const auto files = write(*built_in().artifact(*built_in().maker("connect"), name), joined_angle(),
                           request, "part");
  EXPECT_TRUE(files) << name << ": " << (files ? "" : files.error().message);
  return files && files->size() == 1 ? (*files)[0].bytes : "";
}

TEST(Artifacts, AreFilesOfTheirFormat) {
  EXPECT_THAT(bytes_of("dxf"), StartsWith("  0\nSECTION"));
  EXPECT_NE(bytes_of("svg").find("<svg"), std::string::npos);
  for (const char* step : {"step", "flat.step"})
    EXPECT_THAT(bytes_of(step), StartsWith("ISO-10303-21;"));
  EXPECT_NE(bytes_of("step"), bytes_of("flat.step"));
  EXPECT_THAT(bytes_of("pdf"), StartsWith("%PDF"));
  EXPECT_EQ(bytes_of("json"), joined_angle().json());
  EXPECT_NE(bytes_of("obj").find("\nv "), std::string::npos);
  // Of a binary STL, 80 bytes and a count, then 50 bytes a triangle.
  const std::string stl = bytes_of("stl");
  EXPECT_EQ(stl.size(), 84 + 50 * joined_angle().folded_mesh()->triangles.size());
}

TEST(Artifacts, AreWrittenAsTheRequestAsks) {
  Request request;
  request.dxf.version = DxfVersion::r12;
  EXPECT_NE(bytes_of("dxf", request).find("AC1009"), std::string::npos);
  request.dxf.units = LengthUnit::m;
  EXPECT_EQ(bytes_of("dxf", request), [&] {
    request.dxf.units = LengthUnit::mm;
    return bytes_of("dxf", request);
  }()) << "in the unit of the report";
}

class Pieces : public Made {
 public:
  explicit Pieces(int count) : count_(count) {}
  const Report& report() const override { return report_; }
  Report& report() override { return report_; }
  std::string json() const override { return "{}"; }
  std::string text() const override { return ""; }
  int pieces() const override { return count_; }
  Result<std::string> folded_solid(int piece) const override {
    if (piece > 1) return fail(code::internal, "no third");
    return "solid " + std::to_string(piece);
  }

 private:
  Report report_;
  int count_;
};

TEST(Artifacts, AreNumberedWhereEachPieceHasItsOwn) {
  const Artifact& step = *built_in().artifact(*built_in().maker("connect"), "step");
  const auto files = write(step, Pieces(2), {}, "net");
  ASSERT_TRUE(files);
  ASSERT_EQ(files->size(), 2u);
  EXPECT_EQ((*files)[0].name, "net-1.step");
  EXPECT_EQ((*files)[0].bytes, "solid 0");
  EXPECT_EQ((*files)[1].name, "net-2.step");
  EXPECT_EQ((*files)[1].bytes, "solid 1");
  EXPECT_EQ((*files)[1].artifact, &step);
  EXPECT_EQ((*write(step, Pieces(1), {}, "net"))[0].name, "net.step");
  EXPECT_FALSE(write(step, Pieces(3), {}, "net")) << "all or none";
  const Artifact& json = *built_in().artifact(*built_in().maker("connect"), "json");
  EXPECT_EQ(write(json, Pieces(2), {}, "net")->size(), 1u);
}

TEST(Artifacts, OfASolidOrMouldMayBeMissing) {
  for (const Artifact& one : artifacts()) {
    const bool beside = one.role == Role::folded || one.role == Role::mould;
    EXPECT_EQ(one.may_be_missing({code::internal, "m", ""}), beside) << one.name;
    EXPECT_FALSE(one.may_be_missing({code::cancelled, "m", ""})) << one.name;
  }
}

TEST(Artifacts, ThatAreMissingAreNotedOnce) {
  Report report;
  const auto named = [](const char* name) -> const Artifact& {
    return *std::ranges::find(artifacts(), name, &Artifact::name);
  };
  note_missing(report, named("step"), {code::internal, "no solid", ""});
  note_missing(report, named("stl"), {code::internal, "no solid", ""});
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_EQ(report.findings[0].code, "folded_solid");
  EXPECT_EQ(report.findings[0].severity, Severity::warning);
  EXPECT_NE(report.findings[0].message.find("no solid"), std::string::npos);
  note_missing(report, named("mould.stl"), {code::internal, "no mould", ""});
  ASSERT_EQ(report.findings.size(), 2u);
  EXPECT_EQ(report.findings[1].code, "mould");
}

TEST(Artifacts, HaveNamesOfTheirOwnAndEndInTheirSuffix) {
  std::set<std::string_view> names, ends;
  for (const Artifact& one : artifacts()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_TRUE(one.file_end.ends_with(one.suffix)) << one.name;
    EXPECT_EQ(one.by_piece(), one.source == Source::pattern || one.source == Source::folded_solid);
    EXPECT_EQ(role_name(one.role).empty(), false);
  }
  EXPECT_EQ(role_name(Role::flat), "flat");
  EXPECT_EQ(role_name(Role::folded), "folded");
  EXPECT_EQ(role_name(Role::mould), "mould");
  EXPECT_EQ(role_name(Role::report), "report");
}

}  // namespace
}  // namespace planish::job
