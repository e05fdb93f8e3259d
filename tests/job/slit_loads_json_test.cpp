#include <planish/job/slit_json.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

// Material, weight and loads in slit files.

namespace planish::job {
namespace {

using nlohmann::json;

json loaded() {
  return json::parse(R"({"units": "inch", "thickness": 0.1,
    "sheet": {"strips": 2, "strip_width": 2, "panel_height": 10, "half_length": 12},
    "leg_curve": {"bezier": [[9, 0], [9, 4]]},
    "material": {"young": 9000, "poisson": 0.1, "density": 0.7, "yield": 60}, "gravity": true,
    "loads": [{"strip": 1, "at": 0.5, "force": [0, -750, 3]},
              {"strip": 0, "force": [0, -1, 0]}]})");
}

std::string mistake(const json& document, const std::optional<std::filesystem::path>& folder = {}) {
  const auto file = parse_slits(document.dump(), "s.json", folder);
  return file ? "read" : file.error().where;
}

TEST(SlitLoadsJson, AreInNewtonsWhateverTheUnitOfLengths) {
  const auto file = parse_slits(loaded().dump(), "s.json", {});
  ASSERT_TRUE(file);
  const SlitDesign& design = file->design;
  EXPECT_TRUE(design.gravity);
  EXPECT_EQ(design.material, (SlitMaterial{9000.0, 0.1, 0.7, 60.0}));
  ASSERT_EQ(design.loads.size(), 2u);
  EXPECT_EQ(design.loads[0], (SlitLoad{1, 0.5, Vec3(0, -750, 3)}));
  EXPECT_FALSE(design.loads[1].at);
}

TEST(SlitLoadsJson, OfAFileWithoutThemAreNone) {
  json document = loaded();
  for (const char* key : {"material", "gravity", "loads"})
    document.erase(key);
  const auto file = parse_slits(document.dump(), "s.json", {});
  EXPECT_FALSE(file->design.material);
  EXPECT_FALSE(file->design.gravity);
  EXPECT_TRUE(file->design.loads.empty());
}

TEST(SlitLoadsJson, MistakesNameTheirPlace) {
  const auto with = [](const char* pointer, const json& value) {
    json document = loaded();
    document[json::json_pointer(pointer)] = value;
    return mistake(document);
  };
  EXPECT_EQ(with("/material/young", 0), "s.json/material/young");
  EXPECT_EQ(with("/material/poisson", 0.5), "s.json/material/poisson");
  EXPECT_EQ(with("/material/mass", 7), "s.json/material/mass");
  EXPECT_EQ(with("/loads/0/force", {0, 1}), "s.json/loads/0/force");
  EXPECT_EQ(with("/loads/0/force/1", "750 kg"), "s.json/loads/0/force/1");
  EXPECT_EQ(with("/loads/1/at", 1.5), "s.json/loads/1/at");
  EXPECT_EQ(with("/loads/1/mass", 75), "s.json/loads/1/mass");
}

TEST(SlitLoadsJson, MaterialOfAFileIsThatOfItsFirstLineOrItsKeys) {
  const auto folder = std::filesystem::path(testing::TempDir());
  json document = loaded();
  document["material"] = "planish_slit_material.json";
  const auto read_with = [&](const char* more) {
    std::ofstream(folder / "planish_slit_material.json")
        << R"({"format": "planish/material", "version": 1)" << more << "}";
    return parse_slits(document.dump(), "s.json", folder);
  };
  const auto of_curve = read_with(R"(, "tension": {"points": [[0.001, 210], [0.2, 350]]})");
  ASSERT_TRUE(of_curve);
  EXPECT_DOUBLE_EQ(of_curve->design.material->young, 210000.0);
  EXPECT_EQ(of_curve->design.material->yield, 210.0);
  EXPECT_FALSE(of_curve->design.material->density);
  constexpr auto kLaw = R"(, "tension": {"power_law": {"strength": 550, "exponent": 0.2}})";
  const auto stated = read_with(
      (std::string(kLaw) + R"(, "young": 70000, "poisson": 0.33, "density": 2.7, "yield": 90)")
          .c_str());
  EXPECT_EQ(stated->design.material, (SlitMaterial{70000.0, 0.33, 2.7, 90.0}));
  EXPECT_EQ(read_with(kLaw).error().where,
            (folder / "planish_slit_material.json").string() + "/young");
  std::filesystem::remove(folder / "planish_slit_material.json");
  EXPECT_EQ(parse_slits(document.dump(), "s.json", folder).error().code, code::cannot_read);
  const auto files = slit_files_of(document.dump());
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0].pointer, "/material");
}

}  // namespace
}  // namespace planish::job
