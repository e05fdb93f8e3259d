#include "shape.hpp"

#include <bit>

namespace planish::studio {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are sent as they lie in memory");

Json arrays_json(const Shape& shape) {
  Json json = Json::object();
  std::size_t at = 0;
  for (const ShapeArray& array : shape.arrays) {
    json[array.name] = {{"type", array.type}, {"at", at}, {"count", array.bytes.size() / 4}};
    at += array.bytes.size();
  }
  return json;
}

std::string header(const Shape& shape, double seconds) {
  // The report is already text; parsing it only to write it again would cost more than all the
  // rest. Up to half of it is indentation, which the browser would have to read.
  std::string text = "{\"report\": " +
                     (shape.report.empty() ? "null" : without_indents(shape.report));
  const auto add = [&](const char* key, const Json& value) {
    text += std::string(",\"") + key + "\": " + json_text(value);
  };
  add("arrays", arrays_json(shape));
  add("parts", shape.parts);
  add("root", shape.root ? rows_json(*shape.root) : Json());
  text += ",\"handles\": " + shape.handles;
  add("pierces", shape.pierces ? Json(*shape.pierces) : Json(nullptr));
  add("seconds", seconds);
  text += "}";
  text.resize((text.size() + 3) / 4 * 4, ' ');
  return text;
}

}  // namespace

Json rows_json(const Eigen::Isometry3d& motion) {
  Json json = Json::array();
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      json.push_back(motion.matrix()(row, column));
  return json;
}

void add_space(Shape& shape, const MeshOfFaces& solid) {
  std::vector<float> points;
  for (const Vec3& p : solid.mesh.points)
    for (int i = 0; i < 3; ++i)
      points.push_back(static_cast<float>(p[i]));
  std::vector<std::uint32_t> triangles;
  for (const auto& triangle : solid.mesh.triangles)
    for (const int corner : triangle)
      triangles.push_back(static_cast<std::uint32_t>(corner));
  shape.add("space_points", points);
  shape.add("space_triangles", triangles);
  const auto faces = mapped(solid.face,
                            [&](int face) { return static_cast<std::uint32_t>(face + 1); });
  shape.add("space_faces", faces);
}

std::string encoded(const Shape& shape, double seconds) {
  const std::string head = header(shape, seconds);
  const auto length = static_cast<std::uint32_t>(head.size());
  std::size_t size = 8 + head.size();
  for (const ShapeArray& array : shape.arrays)
    size += array.bytes.size();
  std::string bytes;
  bytes.reserve(size);
  bytes = "PLN1";
  bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
  bytes += head;
  for (const ShapeArray& array : shape.arrays)
    bytes += array.bytes;
  return bytes;
}

}  // namespace planish::studio
