#include <planish/io/flat_writers.hpp>

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(LengthUnits, AreWhatTheyMeasure) {
  EXPECT_EQ(millimetres_in(LengthUnit::mm), 1.0);
  EXPECT_EQ(millimetres_in(LengthUnit::inch), 25.4);
  EXPECT_EQ(millimetres_in(LengthUnit::m), 1000.0);
}

TEST(LayerNames, AreFitForR12) {
  // At most 31 characters: letters, digits, underscores, in capitals.
  for (const auto profile : {LayerProfile::standard, LayerProfile::inventor, LayerProfile::onshape,
                             LayerProfile::solid_edge}) {
    const LayerNames names = layer_names(profile);
    for (const std::string& name : {names.outer, names.openings, names.bend_up, names.bend_down,
                                    names.bend_zone, names.features, names.slits}) {
      EXPECT_LE(name.size(), 31u) << name;
      EXPECT_EQ(name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_"), std::string::npos)
          << name;
    }
  }
}

TEST(LayerNames, OfFormedFeaturesHaveNoWordOfBends) {
  for (const auto profile : {LayerProfile::standard, LayerProfile::inventor, LayerProfile::onshape,
                             LayerProfile::solid_edge})
    for (const char* word : {"BEND", "TANGENT"})
      EXPECT_EQ(layer_names(profile).features.find(word), std::string::npos);
}

}  // namespace
}  // namespace planish
