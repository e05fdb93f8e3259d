#include "body.hpp"
#include "guarded.hpp"
#include "step_out.hpp"
#include "thicken.hpp"

#include <planish/brep/step.hpp>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

namespace planish {

Result<Body> folded_body(const Sheet& sheet, const std::string& name) {
  return brep::guarded(
      [&]() -> Result<Body> {
        auto solid = brep::thicken(sheet);
        if (!solid) return pass_on(solid);
        TopTools_IndexedMapOfShape faces;
        TopExp::MapShapes(*solid, TopAbs_FACE, faces);
        return Body(std::make_shared<const Body::Shape>(
            Body::Shape{std::move(*solid), name, 1, faces.Extent()}));
      },
      name);
}

Result<std::string> step_text(const Body& body) {
  return brep::guarded([&] { return brep::step_text(body.shape().solid, body.name()); },
                       body.name());
}

Result<std::string> folded_solid_step(const Sheet& sheet, const std::string& name) {
  const auto body = folded_body(sheet, name);
  return body ? step_text(*body) : pass_on(body);
}

}  // namespace planish
