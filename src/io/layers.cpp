#include <planish/base/assert.hpp>
#include <planish/io/flat_writers.hpp>

namespace planish {

LayerNames layer_names(LayerProfile profile) {
  switch (profile) {
    case LayerProfile::standard:
      return {"OUTER_PROFILE", "INTERIOR_PROFILES", "BEND_UP", "BEND_DOWN",
              "BEND_TANGENT",  "FEATURE_PROFILES",  "SLITS"};
    case LayerProfile::inventor:
      return {"IV_OUTER_PROFILE", "IV_INTERIOR_PROFILES", "IV_BEND", "IV_BEND_DOWN",
              "IV_TANGENT",       "IV_FEATURE_PROFILES",  "SLITS"};
    case LayerProfile::onshape:
      return {"SHEETMETAL_CUT_LINES",       "SHEETMETAL_CUT_LINES",
              "SHEETMETAL_BEND_LINES_UP",   "SHEETMETAL_BEND_LINES_DOWN",
              "SHEETMETAL_BEND_TANGENT_LI", "SHEETMETAL_FEATURE_PROFILES",
              "SHEETMETAL_CUT_LINES"};
    case LayerProfile::solid_edge:
      return {"OUTER_LOOP", "INTERIOR_LOOPS",   "UP_CENTERLINES", "DOWN_CENTERLINES",
              "",           "FEATURE_PROFILES", "SLITS"};
  }
  PLANISH_ASSERT(!"a profile of the list");
  return {};
}

}  // namespace planish
