#include "body.hpp"
#include "coordinate_bound.hpp"
#include "exchange_lock.hpp"
#include "guarded.hpp"
#include "identical.hpp"
#include "step_header.hpp"

#include <Message_ProgressIndicator.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

namespace planish {
namespace {

using brep::Fingerprint;
using brep::guarded;

std::string label_name(const TDF_Label& label) {
  Handle(TDataStd_Name) attribute;
  if (!label.FindAttribute(TDataStd_Name::GetID(), attribute)) return {};
  const TCollection_ExtendedString& text = attribute->Get();
  std::string name(static_cast<size_t>(text.LengthOfCString()), '\0');
  Standard_PCharacter raw = name.data();
  text.ToUTF8CString(raw);
  return name;
}

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

/// Collects the solids of a document: a repeated TShape is another copy of the same body.
class BodyCollector {
 public:
  void add_tree(const TDF_Label& label, const TopLoc_Location& place) {
    TDF_Label definition = label;
    TopLoc_Location here = place;
    if (XCAFDoc_ShapeTool::IsReference(label)) {
      XCAFDoc_ShapeTool::GetReferredShape(label, definition);
      here = place * XCAFDoc_ShapeTool::GetLocation(label);
    }
    if (XCAFDoc_ShapeTool::IsAssembly(definition)) {
      TDF_LabelSequence parts;
      XCAFDoc_ShapeTool::GetComponents(definition, parts);
      for (int i = 1; i <= parts.Length(); ++i)
        add_tree(parts.Value(i), here);
      return;
    }
    add_shape(XCAFDoc_ShapeTool::GetShape(definition).Moved(here), label_name(definition));
  }

  StepFile take(const Progress& progress) && {
    merge_congruent(progress);
    StepFile file;
    for (Row& row : rows_) {
      if (row.shape.name.empty()) row.shape.name = fmt::format("body-{}", file.bodies.size() + 1);
      file.bodies.emplace_back(std::make_shared<const Body::Shape>(std::move(row.shape)));
    }
    file.surface_bodies = surface_bodies_;
    return file;
  }

 private:
  struct Row {
    Body::Shape shape;
    Fingerprint fingerprint;
  };

  void add_shape(const TopoDS_Shape& shape, const std::string& name) {
    for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next())
      add_solid(TopoDS::Solid(solids.Current()), name);
    for (TopExp_Explorer shells(shape, TopAbs_SHELL, TopAbs_SOLID); shells.More(); shells.Next())
      ++surface_bodies_;
    for (TopExp_Explorer faces(shape, TopAbs_FACE, TopAbs_SHELL); faces.More(); faces.Next())
      ++surface_bodies_;
  }

  void add_solid(const TopoDS_Solid& solid, const std::string& name) {
    for (Row& row : rows_) {
      if (!row.shape.solid.IsPartner(solid)) continue;
      ++row.shape.quantity;
      return;
    }
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(solid, TopAbs_FACE, faces);
    rows_.push_back({{solid, name, 1, faces.Extent()}, {}});
  }

  void merge_congruent(const Progress& progress) {
    if (rows_.size() < 2) return;
    std::vector<Row> distinct;
    for (Row& row : rows_) {
      if (progress.should_stop()) return;
      const double share = static_cast<double>(&row - rows_.data()) /
                           static_cast<double>(rows_.size());
      progress.at("comparing bodies", std::lerp(kTranslated, 1.0, share));
      row.fingerprint = brep::fingerprint_of(row.shape.solid);
      const auto same = std::find_if(distinct.begin(), distinct.end(), [&](const Row& known) {
        return brep::identical(known.fingerprint, row.fingerprint);
      });
      if (same == distinct.end())
        distinct.push_back(std::move(row));
      else
        same->shape.quantity += row.shape.quantity;
    }
    rows_ = std::move(distinct);
  }

  std::vector<Row> rows_;
  int surface_bodies_ = 0;
};

/// A new document, closed with this object; otherwise the kernel's application would keep it.
class OpenDocument {
 public:
  OpenDocument() { XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document); }
  OpenDocument(const OpenDocument&) = delete;
  OpenDocument& operator=(const OpenDocument&) = delete;
  ~OpenDocument() { XCAFApp_Application::GetApplication()->Close(document); }

  Handle(TDocStd_Document) document;
};

std::string file_unit(STEPControl_Reader& reader) {
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.FileUnits(lengths, angles, solid_angles);
  if (lengths.IsEmpty()) return "mm";
  const std::string name = lengths.First().ToCString();
  if (name == "millimetre" || name == "MILLIMETRE") return "mm";
  if (name == "metre" || name == "METRE") return "m";
  return name;
}

double millimetres_in(const std::string& unit) {
  constexpr double kMetre = 1000.0, kInch = 25.4;
  if (unit == "mm") return 1.0;
  return unit == "m" ? kMetre : kInch;  // other units are smaller than a metre
}

/// `path` is the file's path: files that it refers to are sought beside it.
Result<StepFile> transfer(const std::string& text, const std::string& path, const std::string& name,
                          const Progress& progress) {
  return guarded(
      [&]() -> Result<StepFile> {
        const auto lock = brep::exchange_lock();
        STEPCAFControl_Reader reader;
        reader.SetColorMode(false);
        reader.SetLayerMode(false);
        reader.SetPropsMode(false);
        reader.SetGDTMode(false);
        reader.SetMatMode(false);
        reader.SetViewMode(false);
        progress.at("reading", 0.0);
        std::istringstream stream(text);
        if (reader.ChangeReader().ReadStream(path.c_str(), stream) != IFSelect_RetDone)
          return fail(
              ErrorCode::invalid_input,
              fmt::format("{} cannot be read: its STEP syntax is broken; export it again.", name),
              name);
        if (auto error = brep::point_too_far_away(*reader.Reader().StepModel(),
                                                  millimetres_in(file_unit(reader.ChangeReader())),
                                                  name))
          return tl::unexpected(std::move(*error));
        const auto stopped = [&] {
          return fail(ErrorCode::cancelled, "Stopped while reading " + name + ".", name);
        };
        if (progress.should_stop()) return stopped();
        OpenDocument open;
        const Handle(Translating) translating = new Translating(progress);
        const bool whole = reader.Transfer(open.document, translating->Start());
        if (progress.should_stop()) return stopped();
        if (!whole)
          return fail(ErrorCode::no_solid,
                      fmt::format("{} holds no shape that can be read; export a solid body.", name),
                      name);
        BodyCollector collector;
        TDF_LabelSequence roots;
        XCAFDoc_DocumentTool::ShapeTool(open.document->Main())->GetFreeShapes(roots);
        for (int i = 1; i <= roots.Length(); ++i)
          collector.add_tree(roots.Value(i), {});
        StepFile result = std::move(collector).take(progress);
        result.unit = file_unit(reader.ChangeReader());
        if (progress.should_stop()) return stopped();
        return result;
      },
      name);
}

Result<StepFile> check_bodies(StepFile file, const std::string& name) {
  if (!file.bodies.empty()) return file;
  if (file.surface_bodies > 0)
    return fail(
        ErrorCode::shell_not_solid,
        fmt::format(
            "{} holds {} surface {} but no solid; knit the surfaces into a solid and export again.",
            name, file.surface_bodies, file.surface_bodies == 1 ? "body" : "bodies"),
        name);
  return fail(ErrorCode::no_solid,
              fmt::format("{} holds no solid body; export the part as a solid.", name), name);
}

Result<StepFile> read_checked(const std::string& text, const std::string& path,
                              const std::string& name, const Progress& progress) {
  auto header = brep::read_step_header(text, name);
  if (!header) return tl::unexpected(header.error());
  auto content = transfer(text, path, name, progress);
  if (!content) return content;
  content->schema = header->schema;
  content->cad_system = header->cad_system;
  return check_bodies(std::move(*content), name);
}

}  // namespace

Result<StepFile> read_step(const std::filesystem::path& file, const Progress& progress) {
  const std::string name = file.filename().string();
  std::error_code status;
  if (std::filesystem::is_directory(file, status))
    return fail(ErrorCode::cannot_read,
                fmt::format("{} is a folder, not a STEP file.", file.string()), file.string());
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    return fail(ErrorCode::cannot_read,
                fmt::format("{} cannot be opened: {}.", file.string(),
                            std::filesystem::exists(file, status) ? "permission denied"
                                                                  : "there is no such file"),
                file.string());
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  return read_checked(text, file.string(), name, progress);
}

Result<StepFile> read_step_text(const std::string& text, const std::string& name,
                                const Progress& progress) {
  return read_checked(text, name, name, progress);
}

}  // namespace planish
