#include "step_materials.hpp"

#include "step_text.hpp"

#include <planish/base/text.hpp>

#include <Interface_InterfaceModel.hxx>
#include <Quantity_Color.hxx>
#include <STEPConstruct_Styles.hxx>
#include <StepBasic_DerivedUnit.hxx>
#include <StepBasic_DerivedUnitElement.hxx>
#include <StepBasic_MeasureWithUnit.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_SiUnit.hxx>
#include <StepBasic_Unit.hxx>
#include <StepRepr_CharacterizedDefinition.hxx>
#include <StepRepr_DescriptiveRepresentationItem.hxx>
#include <StepRepr_MeasureRepresentationItem.hxx>
#include <StepRepr_PropertyDefinition.hxx>
#include <StepRepr_PropertyDefinitionRepresentation.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepRepr_RepresentedDefinition.hxx>
#include <StepVisual_Colour.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <cmath>

// Materials and colours, as CAD systems write them. A material is a product's `material property`:
// its description is the name, its measure the density. Some write units wrongly, so a density that
// no sheet has counts as unknown. A body has its own colour, else the one that all its faces share,
// else that of its product.

namespace planish::brep {
namespace {

constexpr double kKilo = 1e3, kDeci = 1e-1, kCenti = 1e-2, kMilli = 1e-3;

/// What a prefix stands for; none for those that nobody weighs or measures with.
std::optional<double> factor_of(const StepBasic_SiUnit& unit) {
  if (!unit.HasPrefix()) return 1.0;
  switch (unit.Prefix()) {
    case StepBasic_spKilo:
      return kKilo;
    case StepBasic_spDeci:
      return kDeci;
    case StepBasic_spCenti:
      return kCenti;
    case StepBasic_spMilli:
      return kMilli;
    default:
      return std::nullopt;
  }
}

struct DensityUnit {
  double mass, volume;  ///< kg, dm³
};

/// Some write the volume with exponent 3, not −3. What the unit lacks is 0.
std::optional<DensityUnit> density_unit(const StepBasic_DerivedUnit& unit) {
  DensityUnit found{0.0, 0.0};
  for (int i = 1; i <= unit.NbElements(); ++i) {
    const auto& element = unit.ElementsValue(i);
    const auto si = Handle(StepBasic_SiUnit)::DownCast(element->Unit());
    if (si.IsNull()) return std::nullopt;
    const auto factor = factor_of(*si);
    if (!factor) return std::nullopt;
    if (si->Name() == StepBasic_sunGram && element->Exponent() == 1.0)
      found.mass = *factor / kKilo;
    else if (si->Name() == StepBasic_sunMetre && std::abs(element->Exponent()) == 3.0)
      found.volume = std::pow(*factor * 10.0, 3.0);  // dm³
    else
      return std::nullopt;
  }
  return found;
}

std::optional<double> density_in(const StepRepr_MeasureRepresentationItem& item) {
  if (item.Measure().IsNull()) return std::nullopt;
  const auto unit = Handle(StepBasic_DerivedUnit)::DownCast(
      item.Measure()->UnitComponent().Value());
  if (unit.IsNull()) return std::nullopt;
  const auto one = density_unit(*unit);
  if (!one) return std::nullopt;
  // Lighter than foam or heavier than any metal: the unit is not what it says, or lacks one of the
  // two, which makes it 0 or infinite.
  constexpr double kLightest = 0.05, kHeaviest = 23.0;
  const double density = item.Measure()->ValueComponent() * one->mass / one->volume;
  if (!(density >= kLightest && density <= kHeaviest)) return std::nullopt;
  return density;
}

/// The property that a representation is of, if it is one of materials.
Handle(StepRepr_PropertyDefinition)
    material_property(const StepRepr_PropertyDefinitionRepresentation& one) {
  const Handle(StepRepr_PropertyDefinition) property = one.Definition().PropertyDefinition();
  if (property.IsNull() || property->Name().IsNull()) return {};
  std::string name = property->Name()->ToCString();
  std::ranges::replace(name, '_', ' ');
  return name == "material property" ? property : Handle(StepRepr_PropertyDefinition)();
}

void note(StepMaterial& material, const Handle(StepRepr_RepresentationItem) & item) {
  if (const auto text = Handle(StepRepr_DescriptiveRepresentationItem)::DownCast(item);
      !text.IsNull() && material.name.empty()) {
    material.name = step_text(text->Description());
    if (material.name.empty()) material.name = step_text(text->Name());
  }
  if (const auto measure = Handle(StepRepr_MeasureRepresentationItem)::DownCast(item);
      !measure.IsNull() && !material.density)
    material.density = density_in(*measure);
}

}  // namespace

std::map<const StepBasic_ProductDefinition*, StepMaterial> step_materials(
    const Handle(XSControl_WorkSession) & session) {
  std::map<const StepBasic_ProductDefinition*, StepMaterial> materials;
  const Handle(Interface_InterfaceModel) model = session->Model();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto one = Handle(StepRepr_PropertyDefinitionRepresentation)::DownCast(model->Value(i));
    if (one.IsNull()) continue;
    const auto property = material_property(*one);
    if (property.IsNull() || one->UsedRepresentation().IsNull()) continue;
    const Handle(StepBasic_ProductDefinition) product = property->Definition().ProductDefinition();
    if (product.IsNull()) continue;
    const auto& representation = one->UsedRepresentation();
    for (int k = 1; k <= representation->NbItems(); ++k)
      note(materials[product.get()], representation->ItemsValue(k));
  }
  return materials;
}

ShapeColours shape_colours(const Handle(XSControl_WorkSession) & session) {
  ShapeColours colours;
  STEPConstruct_Styles styles(session);
  if (!styles.LoadStyles()) return colours;
  const Handle(Transfer_TransientProcess) process = session->TransferReader()->TransientProcess();
  for (int i = 1; i <= styles.NbStyles(); ++i) {
    const Handle(StepVisual_StyledItem) style = styles.Style(i);
    if (style.IsNull() || style->Item().IsNull()) continue;
    Handle(StepVisual_Colour) surface, boundary, curve, rendered;
    double transparency = 0.0;
    bool of_component = false;
    if (!styles.GetColors(style, surface, boundary, curve, rendered, transparency, of_component))
      continue;
    Quantity_Color colour;
    if (surface.IsNull() || !STEPConstruct_Styles::DecodeColor(surface, colour)) continue;
    if (process->MapIndex(style->Item()) == 0) continue;
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process, style->Item());
    if (shape.IsNull()) continue;
    const TCollection_AsciiString hex = Quantity_Color::ColorToHex(colour);
    colours.Bind(shape.Located(TopLoc_Location()), lower_case(hex.ToCString()));
  }
  return colours;
}

std::string colour_of(const TopoDS_Shape& solid, const TopoDS_Shape& product,
                      const ShapeColours& colours) {
  if (const std::string* own = colours.Seek(solid)) return *own;
  const std::string* common = nullptr;
  bool same = true;
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More() && same; faces.Next()) {
    const std::string* one = colours.Seek(faces.Current());
    same = one != nullptr && (common == nullptr || *common == *one);
    common = one;
  }
  if (same && common != nullptr) return *common;
  const std::string* whole = colours.Seek(product);
  return whole != nullptr ? *whole : std::string();
}

}  // namespace planish::brep
