#include "step_materials.hpp"

#include "step_out.hpp"

#include <planish/brep/step.hpp>

#include <BRepPrimAPI_MakeBox.hxx>
#include <TopExp_Explorer.hxx>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace planish::brep {
namespace {

/// A box as STEP text, with these entities besides; "PRODUCT" in them is its product definition.
std::string box_text_with(std::string entities) {
  std::string text = step_text(BRepPrimAPI_MakeBox(30, 20, 2).Shape(), "lid").value();
  const size_t definition = text.find("PRODUCT_DEFINITION('");
  const size_t number = text.rfind('#', definition);
  const std::string id = text.substr(number, text.find_first_of(" =", number) - number);
  for (size_t at = entities.find("PRODUCT"); at != std::string::npos; at = entities.find("PRODUCT"))
    entities.replace(at, 7, id);
  return text.insert(text.rfind("ENDSEC;"), entities);
}

std::string named_material(const std::string& property, const std::string& item) {
  return "#9001=PROPERTY_DEFINITION('" + property + "','material name',PRODUCT);\n#9002=" + item +
         ";\n#9003=REPRESENTATION_CONTEXT('','');\n#9004=REPRESENTATION('',(#9002),#9003);\n"
         "#9005=PROPERTY_DEFINITION_REPRESENTATION(#9001,#9004);\n";
}

/// A density of this value in a mass unit by the cube of a length unit.
std::string density_entities(const std::string& value, const std::string& mass,
                             const std::string& length, const std::string& exponent = "-3.") {
  return "#9101=PROPERTY_DEFINITION('material property','density',PRODUCT);\n"
         "#9102=(MASS_UNIT()NAMED_UNIT(*)SI_UNIT(" +
         mass + ",.GRAM.));\n#9103=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(" + length +
         ",.METRE.));\n#9104=DERIVED_UNIT_ELEMENT(#9102,1.);\n#9105=DERIVED_UNIT_ELEMENT(#9103," +
         exponent +
         ");\n#9106=DERIVED_UNIT((#9104,#9105));\n"
         "#9107=MEASURE_REPRESENTATION_ITEM('density measure',POSITIVE_RATIO_MEASURE(" +
         value +
         "),#9106);\n#9108=REPRESENTATION_CONTEXT('','');\n#9109=REPRESENTATION('',(#9107),#9108);"
         "\n"
         "#9110=PROPERTY_DEFINITION_REPRESENTATION(#9101,#9109);\n";
}

Body body_with(const std::string& entities) {
  const auto file = read_step_text(box_text_with(entities), "a.step");
  EXPECT_TRUE(file) << file.error().message;
  return file->bodies.at(0);
}

TEST(StepMaterials, AreNamedAsTheFileSpellsThem) {
  EXPECT_EQ(body_with("").material(), "");
  EXPECT_EQ(body_with(named_material("material property",
                                     "DESCRIPTIVE_REPRESENTATION_ITEM('1.4301','X5CrNi18-10')"))
                .material(),
            "X5CrNi18-10");
  EXPECT_EQ(
      body_with(named_material("material_property", "DESCRIPTIVE_REPRESENTATION_ITEM('1.4301','')"))
          .material(),
      "1.4301")
      << "its name where it has no description";
  EXPECT_EQ(body_with(named_material("geometric property",
                                     "DESCRIPTIVE_REPRESENTATION_ITEM('1.4301','1.4301')"))
                .material(),
            "");
}

TEST(StepMaterials, HaveTheirDensityInKilogramsByCubicDecimetres) {
  const auto density = [](const std::string& value, const std::string& mass,
                          const std::string& length, const std::string& exponent = "-3.") {
    return body_with(density_entities(value, mass, length, exponent)).density().value_or(-1.0);
  };
  EXPECT_NEAR(density("7900.", ".KILO.", "$"), 7.9, 1e-12) << "kg/m³";
  EXPECT_NEAR(density("2.7", "$", ".CENTI."), 2.7, 1e-12) << "g/cm³";
  EXPECT_NEAR(density("2.7", ".KILO.", ".DECI."), 2.7, 1e-12);
  EXPECT_NEAR(density("7.9E-6", ".KILO.", ".MILLI."), 7.9, 1e-12) << "kg/mm³";
  EXPECT_NEAR(density("7900.", ".KILO.", "$", "3."), 7.9, 1e-12) << "some write the exponent so";
}

TEST(StepMaterials, HaveNoDensityThatCannotBeOrInUnitsThatAreNone) {
  const auto known = [](const std::string& value, const std::string& mass,
                        const std::string& length, const std::string& exponent = "-3.") {
    return body_with(density_entities(value, mass, length, exponent)).density().has_value();
  };
  EXPECT_TRUE(known("51.", ".KILO.", "$"));
  EXPECT_FALSE(known("49.", ".KILO.", "$")) << "lighter than foam";
  EXPECT_TRUE(known("22900.", ".KILO.", "$"));
  EXPECT_FALSE(known("23100.", ".KILO.", "$")) << "heavier than any metal";
  EXPECT_FALSE(known("7900.", ".KILO.", "$", "-2."));
  EXPECT_FALSE(known("7900.", ".MEGA.", "$"));
  for (const char* element : {"#9104", "#9105"}) {
    std::string entities = density_entities("7.9", ".KILO.", ".DECI.");
    entities.replace(entities.find("#9104,#9105"), 11, element);
    EXPECT_FALSE(body_with(entities).density()) << "a mass or a volume alone: " << element;
  }
}

/// A style for the item of this kind: a colour in thousandths.
std::string styled(int first, const std::string& item, const std::string& rgb) {
  const auto id = [&](int i) { return "#" + std::to_string(first + i); };
  return id(0) + "=COLOUR_RGB(''," + rgb + ");\n" + id(1) + "=FILL_AREA_STYLE_COLOUR(''," + id(0) +
         ");\n" + id(2) + "=FILL_AREA_STYLE('',(" + id(1) + "));\n" + id(3) +
         "=SURFACE_STYLE_FILL_AREA(" + id(2) + ");\n" + id(4) + "=SURFACE_SIDE_STYLE('',(" + id(3) +
         "));\n" + id(5) + "=SURFACE_STYLE_USAGE(.BOTH.," + id(4) + ");\n" + id(6) +
         "=PRESENTATION_STYLE_ASSIGNMENT((" + id(5) + "));\n" + id(7) + "=STYLED_ITEM('color',(" +
         id(6) + ")," + item + ");\n" + id(8) + "=REPRESENTATION_CONTEXT('','');\n" + id(9) +
         "=MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',(" + id(7) + ")," + id(8) +
         ");\n";
}

/// Numbers of the entities of a kind in a text.
std::vector<std::string> ids_of(const std::string& text, const std::string& kind) {
  std::vector<std::string> ids;
  for (size_t at = text.find(kind + "("); at != std::string::npos;
       at = text.find(kind + "(", at + 1)) {
    const size_t number = text.rfind('#', at);
    ids.push_back(text.substr(number, text.find_first_of(" =", number) - number));
  }
  return ids;
}

TEST(ShapeColours, AreThoseOfSolidsAndOfAllFacesInTheFile) {
  const std::string plain = box_text_with("");
  const std::string solid = ids_of(plain, "MANIFOLD_SOLID_BREP").at(0);
  const std::vector<std::string> faces = ids_of(plain, "ADVANCED_FACE");
  ASSERT_EQ(faces.size(), 6u);
  EXPECT_EQ(body_with(styled(9201, solid, "1.,0.,0.")).colour(), "#ff0000");
  EXPECT_EQ(body_with(styled(9201, solid, "0.,0.,1.")).colour(), "#0000ff");
  std::string all, some;
  for (size_t i = 0; i < faces.size(); ++i) {
    const std::string one = styled(9201 + 20 * static_cast<int>(i), faces[i], "0.,1.,0.");
    all += one;
    if (i > 0) some += one;
  }
  EXPECT_EQ(body_with(all).colour(), "#00ff00");
  EXPECT_EQ(body_with(some).colour(), "") << "one face has none";
  EXPECT_EQ(body_with(some + styled(9401, faces[0], "1.,0.,0.")).colour(), "") << "two colours";
}

TEST(ShapeColour, IsTheSolidsOwnThenThatOfAllItsFacesThenThatOfTheProduct) {
  const TopoDS_Shape solid = BRepPrimAPI_MakeBox(30, 20, 2).Solid();
  const TopoDS_Shape product = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer at(solid, TopAbs_FACE); at.More(); at.Next())
    faces.push_back(at.Current());
  ShapeColours colours;
  EXPECT_EQ(colour_of(solid, product, colours), "");
  colours.Bind(product, "#0000ff");
  EXPECT_EQ(colour_of(solid, product, colours), "#0000ff");
  for (size_t i = 0; i + 1 < faces.size(); ++i)
    colours.Bind(faces[i], "#00ff00");
  EXPECT_EQ(colour_of(solid, product, colours), "#0000ff") << "one face has none";
  colours.Bind(faces.back(), "#00ff00");
  EXPECT_EQ(colour_of(solid, product, colours), "#00ff00");
  colours.UnBind(faces[2]);
  colours.Bind(faces[2], "#ffffff");
  EXPECT_EQ(colour_of(solid, product, colours), "#0000ff") << "faces of two colours";
  colours.Bind(solid, "#ff0000");
  EXPECT_EQ(colour_of(solid, product, colours), "#ff0000");
}

}  // namespace
}  // namespace planish::brep
