#include <planish/base/assert.hpp>
#include <planish/io/mesh_writers.hpp>

#include <bit>
#include <cstdint>

namespace planish {
namespace {

constexpr std::size_t kHeaderSize = 80;

/// Lowest byte first, whatever the machine's order.
template <typename Unsigned>
void append(std::string& out, Unsigned value) {
  for (std::size_t byte = 0; byte < sizeof(Unsigned); ++byte)
    out += static_cast<char>(value >> (8 * byte) & 0xFFu);
}

void append(std::string& out, const Eigen::Vector3f& v) {
  for (const float x : v)
    append(out, std::bit_cast<std::uint32_t>(x));
}

std::string header(const std::string& name) {
  std::string text = "STL " + name;
  text.resize(kHeaderSize, ' ');
  return text;
}

}  // namespace

std::string stl_binary(const Mesh& mesh, const std::string& name) {
  std::string facets;
  std::uint32_t count = 0;
  const auto corner = [&](int i) -> Eigen::Vector3f {
    PLANISH_ASSERT(i >= 0 && i < static_cast<int>(mesh.points.size()));
    return mesh.points[i].cast<float>();
  };
  for (const auto& [i, j, k] : mesh.triangles) {
    const Eigen::Vector3f a = corner(i), b = corner(j), c = corner(k);
    // In doubles: the square of a small side underflows a float.
    const Vec3 normal = (b - a).cast<double>().cross((c - a).cast<double>());
    if (!(normal.norm() > 0.0)) continue;
    append(facets, Eigen::Vector3f(normal.normalized().cast<float>()));
    for (const auto& p : {a, b, c})
      append(facets, p);
    append(facets, std::uint16_t{0});
    ++count;
  }
  std::string result = header(name);
  append(result, count);
  return result + facets;
}

}  // namespace planish
