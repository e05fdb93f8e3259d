#include <planish/base/assert.hpp>
#include <planish/io/mesh_writers.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace planish {

std::string obj_text(const Mesh& mesh, const std::string& name) {
  std::string object = name;
  std::ranges::replace_if(
      object, [](unsigned char c) { return c < 0x20; }, ' ');
  object.erase(0, std::min(object.size(), object.find_first_not_of(' ')));
  std::string text = fmt::format("o {}\n", object);
  for (const Vec3& p : mesh.points)
    fmt::format_to(std::back_inserter(text), "v {:.10g} {:.10g} {:.10g}\n", p.x(), p.y(), p.z());
  const auto is_corner = [&](int i) { return i >= 0 && i < std::ssize(mesh.points); };
  for (const auto& [a, b, c] : mesh.triangles) {
    PLANISH_ASSERT(is_corner(a) && is_corner(b) && is_corner(c));
    fmt::format_to(std::back_inserter(text), "f {} {} {}\n", a + 1, b + 1, c + 1);
  }
  return text;
}

}  // namespace planish
