#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace planish {

/// What a place is a place of, spelled in reports as here (formats.md#places).
enum class PlaceKind {
  face,
  edge,
  body,
  flange,
  bend,
  plate,
  strip,
  ridge,
  stroke,
  point,
  pointer,
  line
};

/// "face", "edge", …
std::string_view kind_name(PlaceKind kind);

/// Where something was found, as data: front ends show it, select it or hand it on, and never read
/// it back out of a sentence.
struct Place {
  /// A number or a name, as reports and input files have it; nothing for a point.
  using Id = std::variant<std::monostate, int, std::string>;

  PlaceKind kind = PlaceKind::point;
  Id id = {};
  std::vector<double> at = {};  ///< mm: x, y in the pattern or x, y, z in space; empty: not known
  std::vector<int> faces = {};  ///< of an edge: the faces that meet there

  friend bool operator==(const Place&, const Place&) = default;
};

/// A place as a sentence names it, for people, who count from 1: "face 12", "bend B2",
/// "plate \"floor\"", "strip 3" (of id 2), "(12.5, 40)", "/plates/0", "line 7", and of an edge with
/// its faces "edge 21 between face 7 and face 9".
std::string text_of(const Place& place);

/// The same without its kind: "12", "B2", "\"floor\"".
std::string id_text(const Place& place);

/// A key as a token of a JSON pointer (RFC 6901).
std::string escaped_token(std::string_view key);

namespace place {

/// A face of the solid, by its number in `planish info` (from 1).
inline Place face(int number) { return {PlaceKind::face, number}; }
/// An edge of the solid, likewise, and the faces that meet there.
inline Place edge(int number, std::vector<int> faces = {}) {
  return {PlaceKind::edge, number, {}, std::move(faces)};
}
/// A body of the file, from 1.
inline Place body(int number) { return {PlaceKind::body, number}; }
/// A flange of the flat pattern, from 1.
inline Place flange(int number) { return {PlaceKind::flange, number}; }
/// A bend by its name in reports: "B2".
inline Place bend(std::string name) { return {PlaceKind::bend, std::move(name)}; }
/// A plate by its id in the plates file.
inline Place plate(std::string id) { return {PlaceKind::plate, std::move(id)}; }
/// A strip of a slit sheet as files count: from 0.
inline Place strip(int index) { return {PlaceKind::strip, index}; }
/// A ridge of a strip as files count: from 0.
inline Place ridge(int index) { return {PlaceKind::ridge, index}; }
/// A stroke of a bend plan, from 1.
inline Place stroke(int number) { return {PlaceKind::stroke, number}; }
/// A line of a text file, from 1.
inline Place line(int number) { return {PlaceKind::line, number}; }
/// A field of the request or of a JSON file: "/bends/1/inside_radius".
inline Place pointer(std::string path) { return {PlaceKind::pointer, std::move(path)}; }
/// A point of the pattern, or with three coordinates of space, mm: any vector with begin and end.
template <typename Vector>
Place point(const Vector& p) {
  return {PlaceKind::point, {}, std::vector<double>(p.begin(), p.end())};
}
/// The same place, and where it lies.
template <typename Vector>
Place at(Place place, const Vector& p) {
  place.at.assign(p.begin(), p.end());
  return place;
}

}  // namespace place
}  // namespace planish
