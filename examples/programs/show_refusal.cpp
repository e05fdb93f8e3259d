// A viewer of why a part is refused: the solid as OBJ, the faces that the refusal names in one
// group.
//   show_refusal part.step > refused.obj
#include <planish/job/artifact.hpp>

#include <cstdio>
#include <set>

using namespace planish;

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  job::Request request;
  request.input = argv[1];
  const auto work = job::open_input(*job::built_in().maker("unfold"), request, {});
  if (!work) return std::fprintf(stderr, "%s\n", work.error().message.c_str()), 3;
  const auto made = (*work)->make(request, {});
  if (made) return std::fprintf(stderr, "there is a flat pattern\n"), 1;
  std::fprintf(stderr, "%s\n", made.error().message.c_str());
  if (!made.error().shown) return 3;  // nothing was understood, so nothing is refused
  const auto solid = (*made.error().shown)->refused_solid();
  if (!solid) return std::fprintf(stderr, "its faces cannot be drawn\n"), 1;

  std::set<int> named;
  for (const Place& place : made.error().places) {
    std::fprintf(stderr, "  %s\n", text_of(place).c_str());
    if (place.kind == PlaceKind::face) named.insert(std::get<int>(place.id));
    named.insert(place.faces.begin(), place.faces.end());  // beside an edge
  }
  for (const Vec3& p : solid->mesh.points)
    std::printf("v %.6g %.6g %.6g\n", p.x(), p.y(), p.z());
  for (const bool marked : {false, true}) {
    std::printf("g %s\n", marked ? "named" : "other");
    for (std::size_t i = 0; i < solid->face.size(); ++i) {
      const auto& t = solid->mesh.triangles[i];
      if (named.contains(solid->face[i] + 1) == marked)  // places count faces from 1
        std::printf("f %d %d %d\n", t[0] + 1, t[1] + 1, t[2] + 1);
    }
  }
}
