#include "support/closed_mesh.hpp"
#include "support/real_parts.hpp"

#include <planish/brep/step.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

// The mesh of every body of the real parts is closed, shows all of its faces, and has its volume.

namespace planish::test {
namespace {

namespace fs = std::filesystem;

struct Measures {
  double volume = 0.0, area = 0.0;
};

Measures measures_of(const Mesh& mesh) {
  Measures sum;
  const Vec3 origin = mesh.points.front();
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.points[t[0]] - origin, b = mesh.points[t[1]] - origin,
               c = mesh.points[t[2]] - origin;
    sum.volume += a.dot(b.cross(c)) / 6.0;
    sum.area += 0.5 * (b - a).cross(c - a).norm();
  }
  return sum;
}

/// As another program measured the parts of one solid. Of two chassis with thousands of openings
/// it is 7 % off the faces' integrals and the mesh, which agree.
std::map<std::string, double> known_volumes() {
  std::map<std::string, double> volumes;
  std::ifstream text(real_parts_folder() / "manifest.json");
  if (!text) return volumes;
  for (const auto& part : nlohmann::json::parse(text))
    if (part.value("n_solids", 0) == 1) volumes[part.at("id")] = part.at("volume");
  volumes.erase("sm123_thelio_Internal-V1");
  volumes.erase("sm125_thelio_Internal-V1");
  return volumes;
}

TEST(MeshesOfRealParts, AreClosedAndHaveTheVolumeOfTheirBodies) {
  if (!fs::exists(real_parts_folder())) GTEST_SKIP() << kNoRealParts;
  const auto volumes = known_volumes();
  constexpr double kMeshChord = 0.05;
  // Of this part's full cones, in one body, the kernel makes no triangles, whatever it is asked.
  constexpr const char* kNotMeshed = "asm032_";
  int compared = 0, not_meshed = 0;
  for (const auto& entry : fs::directory_iterator(real_parts_folder())) {
    if (entry.path().extension() != ".step") continue;
    const std::string part = entry.path().stem().string();
    const auto file = read_step(entry.path());
    if (!file) continue;  // not a STEP file with solids: tests/job/corpus_test.cpp
    for (const Body& body : file->bodies) {
      SCOPED_TRACE(part + ", body " + body.name());
      const auto surface = body_mesh(body, kMeshChord);
      if (part.rfind(kNotMeshed, 0) == 0 && !surface) {  // told, not handed out
        EXPECT_EQ(surface.error().code, code::internal);
        EXPECT_EQ(++not_meshed, 1);
        continue;
      }
      ASSERT_TRUE(surface.has_value()) << surface.error().message;
      EXPECT_TRUE(is_closed(surface->mesh));
      const std::set<int> shown(surface->face.begin(), surface->face.end());
      EXPECT_EQ(shown.size(), static_cast<size_t>(body.face_count()));
      const Measures found = measures_of(surface->mesh);
      EXPECT_NEAR(found.volume, body.volume(), kMeshChord * found.area);
      const auto known = volumes.find(part);
      if (known == volumes.end() || file->bodies.size() != 1) continue;
      constexpr double kRounded = 1e-3;  // mm³: the manifest has four decimals, of small parts
      EXPECT_NEAR(found.volume, known->second, kMeshChord * found.area + kRounded);
      ++compared;
    }
  }
  if (compared == 0) GTEST_SKIP() << kNoRealParts;
}

}  // namespace
}  // namespace planish::test
