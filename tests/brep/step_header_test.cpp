#include "step_header.hpp"

#include "support/error_data.hpp"

#include <planish/brep/codes.hpp>

#include <gtest/gtest.h>

namespace planish::brep {
namespace {

/// A file with this schema, preprocessor and originating system.
std::string file_with(const std::string& schema, const std::string& preprocessor,
                      const std::string& system) {
  return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('a; model'),'2;1');\nFILE_NAME('part; #1',"
         "'2026-01-02T03:04:05',('A. Author'),('Works'),'" +
         preprocessor + "','" + system + "','none');\nFILE_SCHEMA(('" + schema +
         "'));\nENDSEC;\nDATA;\n#1=CARTESIAN_POINT('',(0.,0.,0.));\nENDSEC;\nEND-ISO-10303-21;\n";
}

TEST(StepHeader, NamesTheApplicationProtocol) {
  const auto schema = [](const std::string& name) {
    return read_step_header(file_with(name, "P", "S"), "a.step")->schema;
  };
  EXPECT_EQ(schema("CONFIG_CONTROL_DESIGN"), "AP203 (CONFIG_CONTROL_DESIGN)");
  EXPECT_EQ(schema("AP203_CONFIGURATION_CONTROLLED_3D_DESIGN_OF_MECHANICAL_PARTS"),
            "AP203 (AP203_CONFIGURATION_CONTROLLED_3D_DESIGN_OF_MECHANICAL_PARTS)");
  EXPECT_EQ(schema("automotive_design { 1 0 10303 214 }"),
            "AP214 (automotive_design { 1 0 10303 214 })");
  EXPECT_EQ(schema("AP242_MANAGED_MODEL_BASED_3D_ENGINEERING"),
            "AP242 (AP242_MANAGED_MODEL_BASED_3D_ENGINEERING)");
  EXPECT_EQ(schema("SHIP_ARRANGEMENT_SCHEMA"), "SHIP_ARRANGEMENT_SCHEMA");
}

TEST(StepHeader, NamesTheSystemOrWhatWroteIt) {
  const auto system = [](const std::string& preprocessor, const std::string& name) {
    return read_step_header(file_with("AP214", preprocessor, name), "a.step")->cad_system;
  };
  EXPECT_EQ(system("Writer 1", "CAD 9"), "CAD 9");
  EXPECT_EQ(system("Writer 1", ""), "Writer 1");
  EXPECT_EQ(system("Writer 1", "  "), "Writer 1");
  EXPECT_EQ(system("Writer 1", "O''Neill; CAD"), "O'Neill; CAD");
}

TEST(StepHeader, TakesAFileWithoutThem) {
  const std::string
      bare = " \r\nISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=X();\nENDSEC;\nEND-ISO-10303-21;";
  const auto header = read_step_header(bare, "a.step");
  ASSERT_TRUE(header);
  EXPECT_EQ(header->schema, "");
  EXPECT_EQ(header->cad_system, "");
}

TEST(StepHeader, TellsFilesThatAreNotWhole) {
  const auto code_of = [](const std::string& text) {
    const auto header = read_step_header(text, "a.step");
    if (header) return std::string("read");
    EXPECT_NE(header.error().message.find("a.step"), std::string::npos);
    EXPECT_EQ(header.error().where, "a.step");
    return std::string(header.error().code.name);
  };
  const std::string whole = file_with("AP214", "P", "S");
  EXPECT_EQ(code_of(whole), "read");
  EXPECT_EQ(code_of(""), "empty_file");
  EXPECT_EQ(code_of(" \n\t "), "empty_file");
  EXPECT_EQ(code_of("solid ascii stl"), "not_step");
  EXPECT_EQ(code_of("x" + whole), "not_step");
  EXPECT_EQ(code_of(whole.substr(0, whole.size() - 20)), "truncated_file");
  std::string nothing = whole;
  nothing.erase(nothing.find("#1=CART"), std::string("#1=CARTESIAN_POINT('',(0.,0.,0.));").size());
  EXPECT_EQ(code_of(nothing), "no_solid") << "the # in the header is no instance";
}

TEST(StepHeader, FindsTheEndMarkBeforeComments) {
  const std::string whole = file_with("AP214", "P", "S");
  EXPECT_TRUE(read_step_header(whole + std::string(4000, ' '), "a.step"));
  const auto late = read_step_header(whole + std::string(5000, ' '), "a.step");
  ASSERT_FALSE(late);
  EXPECT_EQ(late.error().code, code::truncated_file);
  EXPECT_EQ(planish::test::number_in(late.error(), "count"),
            static_cast<double>(whole.size() + 5000));
}

}  // namespace
}  // namespace planish::brep
