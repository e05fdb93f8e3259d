#include "rim_refusal.hpp"

#include "dihedral.hpp"

#include <planish/brep/codes.hpp>
#include <planish/sheet/codes.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace planish::brep {
namespace {

/// An edge between a face of a part and a skin face.
struct Contact {
  int edge = 0;
  int face = 0;
  int skin = 0;
};

std::vector<Contact> contacts_of(const SolidModel& model,
                                 const std::vector<std::vector<int>>& edges, const Skins& skins,
                                 const RimPart& part) {
  std::vector<Contact> contacts;
  for (const int f : part.faces)
    for (const int e : edges[f]) {
      const int skin = face_across(model.edges[e], f);
      if (skin >= 0 && skins.skin_of[skin] != Skin::none) contacts.push_back({e, f, skin});
    }
  return contacts;
}

/// The face with the largest share of edges outside; of several such the first.
int outermost(const std::vector<int>& faces, const std::vector<std::vector<int>>& edges,
              const std::set<int>& outside) {
  const auto share = [&](int f) {
    const auto out = std::ranges::count_if(edges[f], [&](int e) { return outside.contains(e); });
    return static_cast<double>(out) /
           static_cast<double>(std::max<std::size_t>(edges[f].size(), 1));
  };
  return *std::ranges::max_element(faces, {}, share);
}

std::string face_name(int face) { return fmt::format("face {}", face + 1); }

}  // namespace

Error rim_refusal(const SolidModel& model, const std::vector<std::vector<int>>& edges,
                  const Skins& skins, const RimPart& part, const std::set<int>& outside) {
  const std::vector<Contact> contacts = contacts_of(model, edges, skins, part);
  for (const Contact& at : contacts)
    if (const auto* curved = std::get_if<DoublyCurved>(&model.faces[at.face].surface))
      return {code::doubly_curved,
              fmt::format("Face {} ({}) is curved in two directions: it was drawn or formed, not "
                          "bent, and has no flat pattern.",
                          at.face + 1, curved->kind),
              face_name(at.face)};
  constexpr double kContinues = 0.1;  // radians between the outward normals
  for (const Contact& at : contacts)
    if (const auto angle = dihedral(model, at.edge); angle && std::abs(*angle) < kContinues)
      return {code::thickness_not_constant,
              fmt::format("The material below face {}, which continues face {}, is not {:.4g} mm "
                          "thick.",
                          at.face + 1, at.skin + 1, skins.thickness),
              face_name(at.face)};
  const int face = outermost(part.faces, edges, outside);
  return {code::not_a_sheet,
          fmt::format("At face {} the body extends beyond the sheet of {:.4g} mm; it is not made "
                      "of one sheet.",
                      face + 1, skins.thickness),
          face_name(face)};
}

}  // namespace planish::brep
