#include "product_tree.hpp"

#include "coordinate_bound.hpp"
#include "mend_where_needed.hpp"
#include "refusals.hpp"
#include "step_text.hpp"

#include <IFSelect_WorkLibrary.hxx>
#include <Interface_HGraph.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_Protocol.hxx>
#include <Message_ProgressIndicator.hxx>
#include <NCollection_DataMap.hxx>
#include <STEPConstruct_ExternRefs.hxx>
#include <STEPControl_Reader.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_AsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <cmath>
#include <fstream>
#include <memory>
#include <optional>
#include <set>

// Products down the assemblies of a STEP file and of files that it refers to, with names, places,
// materials and colours. The kernel's check of every entity against the standard is passed by
// (docs/decisions/0010): it takes time with the square of a loop's edges, and nobody asks for what
// it finds. A file that is missing, broken, or being read already holds nothing, so a circle of
// references ends.

namespace planish::brep {
namespace {

namespace fs = std::filesystem;

// Shares of the reading time, for parts of 2 to 4 MB.
constexpr double kParsed = 0.3, kTranslated = 0.9;

/// Tells the caller the progress of the kernel's translation, and the kernel when to stop.
class Translating : public Message_ProgressIndicator {
 public:
  explicit Translating(const Progress& progress) : progress_(progress) {}
  Standard_Boolean UserBreak() override { return progress_.should_stop(); }

 private:
  void Show(const Message_ProgressScope&, Standard_Boolean) override {
    progress_.at("translating", std::lerp(kParsed, kTranslated, GetPosition()));
  }
  const Progress& progress_;
};

double millimetres_in(const std::string& unit) {
  constexpr double kMetre = 1000.0, kInch = 25.4;
  if (unit == "mm") return 1.0;
  return unit == "m" ? kMetre : kInch;  // others are smaller than a metre
}

TopoDS_Shape unplaced(const TopoDS_Shape& shape) { return shape.Located(TopLoc_Location()); }

std::string name_of(const Handle(StepBasic_ProductDefinition) & definition) {
  if (definition->Formation().IsNull() || definition->Formation()->OfProduct().IsNull()) return {};
  const Handle(StepBasic_Product) product = definition->Formation()->OfProduct();
  const std::string name = step_text(product->Name());
  return name.empty() ? step_text(product->Id()) : name;
}

/// The kind of shape, for bodies that belong to no product.
std::string kind_name(const TopoDS_Shape& shape) {
  switch (shape.ShapeType()) {
    case TopAbs_COMPOUND:
      return "COMPOUND";
    case TopAbs_COMPSOLID:
      return "COMPSOLID";
    case TopAbs_SOLID:
      return "SOLID";
    case TopAbs_SHELL:
      return "SHELL";
    default:
      return {};
  }
}

/// A session of the kernel that takes a text as it is. Of itself the kernel checks every entity
/// against the standard as soon as it has them, for which it lists all that an edge loop shares
/// once for each of its edges; nobody asks for what it finds.
class UncheckedSession : public XSControl_WorkSession {
 public:
  /// False when the text is not STEP.
  bool read(std::istream& text, const fs::path& path) {
    const Handle(Interface_Protocol) protocol = Protocol();
    Handle(Interface_InterfaceModel) model;
    if (WorkLibrary()->ReadStream(path.c_str(), text, model, protocol) != 0 || model.IsNull())
      return false;
    // Without a protocol no graph is made, and it is with a graph that checking begins.
    SetProtocol({});
    SetModel(model);
    SetProtocol(protocol);
    thegraph = new Interface_HGraph(model);
    SetLoadedFile(path.c_str());
    InitTransferReader(kWhatHasBeenRead);
    return true;
  }

 private:
  static constexpr int kWhatHasBeenRead = 4;
};

/// A file translated to shapes, with what it says of them.
class Content {
 public:
  /// False when the text is not STEP.
  bool parse(std::istream& text, const fs::path& path) { return session_->read(text, path); }

  std::optional<Error> point_too_far_away(const std::string& name) {
    return brep::point_too_far_away(*reader_.StepModel(), millimetres_in(unit()), name);
  }

  /// False when it holds nothing that is a shape.
  bool translate(const Message_ProgressRange& range) {
    const MendWhereNeeded mending;
    reader_.ClearShapes();
    const int count = reader_.NbRootsForTransfer();
    Message_ProgressScope scope(range, "", count);
    for (int i = 1; i <= count && scope.More(); ++i)
      reader_.TransferOneRoot(i, scope.Next());
    if (!scope.More() || reader_.NbShapes() == 0) return false;
    collect_products();
    collect_references();
    colours_ = shape_colours(reader_.WS());
    return true;
  }

  std::string unit() {
    TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
    reader_.FileUnits(lengths, angles, solid_angles);
    const std::string spelled = lengths.IsEmpty() ? "millimetre" : lengths.First().ToCString();
    if (spelled.empty() || spelled == "millimetre" || spelled == "MILLIMETRE") return "mm";
    if (spelled == "metre" || spelled == "METRE") return "m";
    return spelled;
  }

  std::vector<TopoDS_Shape> roots() const {
    std::vector<TopoDS_Shape> shapes;
    for (int i = 1; i <= reader_.NbShapes(); ++i)
      shapes.push_back(reader_.Shape(i));
    return shapes;
  }

  /// Whether the shape is made of products or representations, not of bodies alone.
  bool is_assembly(const TopoDS_Shape& shape) const {
    if (shape.ShapeType() != TopAbs_COMPOUND) return false;
    for (TopoDS_Iterator part(shape); part.More(); part.Next())
      if (parts_.Contains(unplaced(part.Value()))) return true;
    return false;
  }

  std::string name(const TopoDS_Shape& shape) const {
    const std::string* known = names_.Seek(shape);
    return known != nullptr ? *known : kind_name(shape);
  }

  StepMaterial material(const TopoDS_Shape& product) const {
    const StepMaterial* known = materials_.Seek(product);
    return known != nullptr ? *known : StepMaterial{};
  }

  std::string colour(const TopoDS_Shape& solid, const TopoDS_Shape& product) const {
    return colour_of(unplaced(solid), product, colours_);
  }

  /// The file that stands for an empty shape.
  std::optional<std::string> reference(const TopoDS_Shape& shape) const {
    const std::string* known = references_.Seek(shape);
    if (known == nullptr || shape.NbChildren() > 0) return {};
    return *known;
  }

 private:
  Handle(Transfer_TransientProcess) process() const {
    return reader_.WS()->TransferReader()->TransientProcess();
  }

  void collect_products() {
    const Handle(Interface_InterfaceModel) model = reader_.Model();
    const auto materials = step_materials(reader_.WS());
    for (int i = 1; i <= model->NbEntities(); ++i) {
      const Handle(Standard_Transient) entity = model->Value(i);
      const auto product = Handle(StepBasic_ProductDefinition)::DownCast(entity);
      if (product.IsNull() && !entity->IsKind(STANDARD_TYPE(StepShape_ShapeRepresentation)))
        continue;
      if (process()->MapIndex(entity) == 0) continue;
      const TopoDS_Shape shape = TransferBRep::ShapeResult(process(), entity);
      if (shape.IsNull()) continue;
      parts_.Add(shape);
      if (product.IsNull()) continue;
      names_.Bind(shape, name_of(product));
      if (const auto known = materials.find(product.get()); known != materials.end())
        materials_.Bind(shape, known->second);
    }
  }

  void collect_references() {
    STEPConstruct_ExternRefs files(reader_.WS());
    files.LoadExternRefs();
    for (int i = 1; i <= files.NbExternRefs(); ++i) {
      const Handle(TCollection_HAsciiString) format = files.Format(i);
      if (!format.IsNull() && !format->String().IsEqual("STEP AP203") &&
          !format->String().IsEqual("STEP AP214"))
        continue;
      const Standard_CString file = files.FileName(i);
      const Handle(StepBasic_ProductDefinition) product = files.ProdDef(i);
      if (file == nullptr || *file == '\0' || product.IsNull()) continue;
      const TopoDS_Shape shape = TransferBRep::ShapeResult(process(), product);
      if (!shape.IsNull()) references_.Bind(shape, file);
    }
  }

  template <typename T>
  using ByShape = NCollection_DataMap<TopoDS_Shape, T, TopTools_ShapeMapHasher>;

  Handle(UncheckedSession) session_ = new UncheckedSession;
  STEPControl_Reader reader_{session_, false};
  TopTools_MapOfShape parts_;        // shapes of products and representations
  ByShape<std::string> names_;       // of products
  ByShape<std::string> references_;  // to other files
  ByShape<StepMaterial> materials_;  // of products
  ShapeColours colours_;
};

/// Walks down the assemblies of a file, and of those that it refers to.
class Walk {
 public:
  Walk(const Content& content, fs::path folder, std::set<fs::path> open, ProductTree& tree)
      : content_(content), folder_(std::move(folder)), open_(std::move(open)), tree_(tree) {}

  /// Everything in the file. What an assembly of it uses is found there alone.
  void add_all() {
    const std::vector<TopoDS_Shape> roots = content_.roots();
    for (const TopoDS_Shape& root : roots)
      note_used(root);
    TopTools_MapOfShape seen;
    for (const TopoDS_Shape& root : roots)
      if (!used_.Contains(root) && seen.Add(root)) add(root, TopLoc_Location(), {});
  }

  /// What stands for the whole file; solids right in it get the other name.
  void add_first(const TopLoc_Location& place, const std::string& name) {
    const std::vector<TopoDS_Shape> roots = content_.roots();
    if (!roots.empty()) add(roots.front(), place, name);
  }

 private:
  void note_used(const TopoDS_Shape& shape) {
    const TopoDS_Shape definition = unplaced(shape);
    if (!shape.Location().IsIdentity()) used_.Add(definition);
    if (!content_.is_assembly(definition)) return;
    for (TopoDS_Iterator part(definition); part.More(); part.Next())
      if (used_.Add(unplaced(part.Value()))) note_used(unplaced(part.Value()));
  }

  void add(const TopoDS_Shape& shape, const TopLoc_Location& place,
           const std::optional<std::string>& other_name) {
    const TopoDS_Shape definition = unplaced(shape);
    const TopLoc_Location here = place * shape.Location();
    if (content_.is_assembly(definition)) {
      for (TopoDS_Iterator part(definition); part.More(); part.Next())
        add(part.Value(), here, {});
      return;
    }
    const std::string name = other_name.value_or(content_.name(definition));
    if (const auto file = content_.reference(definition))
      add_file(folder_ / *file, here, name);
    else
      add_bodies(definition, here, name);
  }

  void add_bodies(const TopoDS_Shape& definition, const TopLoc_Location& place,
                  const std::string& name) {
    const TopoDS_Shape shape = definition.Moved(place);
    for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next())
      tree_.solids.push_back({TopoDS::Solid(solids.Current()), name, content_.material(definition),
                              content_.colour(solids.Current(), definition)});
    for (TopExp_Explorer shells(shape, TopAbs_SHELL, TopAbs_SOLID); shells.More(); shells.Next())
      ++tree_.surface_bodies;
    for (TopExp_Explorer faces(shape, TopAbs_FACE, TopAbs_SHELL); faces.More(); faces.Next())
      ++tree_.surface_bodies;
  }

  /// A file that is missing, broken or that refers back to one that is being read holds nothing.
  void add_file(const fs::path& path, const TopLoc_Location& place, const std::string& name) {
    std::set<fs::path> open = open_;
    if (!open.insert(path.lexically_normal()).second) return;
    std::ifstream text(path, std::ios::binary);
    Content content;
    if (!text || !content.parse(text, path) || content.point_too_far_away({}) ||
        !content.translate({}))
      return;
    Walk(content, path.parent_path(), std::move(open), tree_).add_first(place, name);
  }

  const Content& content_;
  fs::path folder_;
  std::set<fs::path> open_;
  ProductTree& tree_;
  TopTools_MapOfShape used_;
};

}  // namespace

Result<ProductTree> read_products(std::istream& text, const fs::path& path, const std::string& name,
                                  const Progress& progress) {
  const auto stopped = [&] { return fail(refuse::reading_stopped, {{"file", name}}, name); };
  progress.at("reading", 0.0);
  const auto content = std::make_shared<Content>();
  if (!content->parse(text, path)) return fail(refuse::broken_syntax, {{"file", name}}, name);
  if (auto error = content->point_too_far_away(name)) return tl::unexpected(std::move(*error));
  if (progress.should_stop()) return stopped();
  progress.at("translating", kParsed);
  const Handle(Translating) translating = new Translating(progress);
  const bool whole = content->translate(translating->Start());
  if (progress.should_stop()) return stopped();
  if (!whole) return fail(refuse::no_shape, {{"file", name}}, name);
  ProductTree tree;
  tree.unit = content->unit();
  tree.content = content;
  Walk(*content, path.parent_path(), {path.lexically_normal()}, tree).add_all();
  return tree;
}

}  // namespace planish::brep
