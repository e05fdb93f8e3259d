#include "rim_refusal.hpp"

#include "dihedral.hpp"
#include "model_places.hpp"
#include "refusals.hpp"

#include <algorithm>
#include <cmath>

// Why faces between the skins are no cut edge of a sheet, as its designer would see it; the
// narrowest cause that applies is told. A face is curved in two directions; or it goes on smoothly
// from a skin, so the sheet has another thickness there; else the face with the largest share of
// edges outside is what stands out.

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

}  // namespace

Error rim_refusal(const SolidModel& model, const std::vector<std::vector<int>>& edges,
                  const Skins& skins, const RimPart& part, const std::set<int>& outside) {
  const std::vector<Contact> contacts = contacts_of(model, edges, skins, part);
  for (const Contact& at : contacts)
    if (const auto* curved = std::get_if<DoublyCurved>(&model.faces[at.face].surface))
      return error_of(refuse::drawn_face,
                      {{"face", face_place(model, at.face)}, {"kind", curved->kind}});
  constexpr double kContinues = 0.1;  // radians between the outward normals
  for (const Contact& at : contacts)
    if (const auto angle = dihedral(model, at.edge); angle && std::abs(*angle) < kContinues)
      return error_of(refuse::other_thickness,
                      {{"face", face_place(model, at.face)},
                       {"skin", face_place(model, at.skin)},
                       {"thickness", skins.thickness, unit::mm}},
                      text_of(place::face(at.face + 1)));
  const int face = outermost(part.faces, edges, outside);
  return error_of(refuse::beyond_sheet,
                  {{"face", face_place(model, face)}, {"thickness", skins.thickness, unit::mm}});
}

}  // namespace planish::brep
