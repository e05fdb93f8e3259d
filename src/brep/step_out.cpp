#include "step_out.hpp"

#include "exchange_lock.hpp"
#include "refusals.hpp"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shape.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

// A shape as STEP text, the same bytes for the same shape: the kernel's time and its count of
// products are replaced, and names are encoded here. Large faces come last, for the kernel measures
// a face again for each edge that was not written before: a plate ahead of the walls of its holes
// would take the square of their number.

namespace planish::brep {
namespace {

/// Placeholder for the name while the kernel writes, which would encode letters beyond ASCII in its
/// own way.
constexpr std::string_view name_mark = "planish-product-name";

Handle(TCollection_HAsciiString) text(const char* content) {
  return new TCollection_HAsciiString(content);
}

void set_parameters() {
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetCVal("write.step.unit", "MM");
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  Interface_Static::SetIVal("write.step.assembly", 0);
  // Curves in surface parameters would double the file size, and readers compute their own.
  Interface_Static::SetIVal("write.surfacecurve.mode", 0);
}

int edge_count(const TopoDS_Shape& face) {
  int count = 0;
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
    ++count;
  return count;
}

/// The same shape, the faces of each shell in the order of their numbers of edges.
TopoDS_Shape large_faces_last(const TopoDS_Shape& shape) {
  if (shape.ShapeType() > TopAbs_SHELL) return shape;
  const bool is_shell = shape.ShapeType() == TopAbs_SHELL;
  std::vector<std::pair<int, TopoDS_Shape>> members;
  for (TopoDS_Iterator each(shape, false, false); each.More(); each.Next())
    members.emplace_back(is_shell ? edge_count(each.Value()) : 0, large_faces_last(each.Value()));
  std::ranges::stable_sort(members, {}, [](const auto& member) { return member.first; });
  // What is added to a turned or moved shape is turned and moved back.
  TopoDS_Shape ordered = shape.EmptyCopied().Located({}).Oriented(TopAbs_FORWARD);
  const BRep_Builder builder;
  for (const auto& [edges, member] : members)
    builder.Add(ordered, member);
  ordered.Closed(shape.Closed());
  return ordered.Located(shape.Location()).Oriented(shape.Orientation());
}

/// The kernel numbers products over the life of the process; only the name is wanted.
void set_product_name(const Handle(StepData_StepModel) & model) {
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(StepBasic_Product) product = Handle(StepBasic_Product)::DownCast(model->Entity(i));
    if (product.IsNull()) continue;
    product->SetId(text(std::string(name_mark).c_str()));
    product->SetName(text(std::string(name_mark).c_str()));
  }
}

void set_header(const Handle(StepData_StepModel) & model) {
  APIHeaderSection_MakeHeader header(model);
  header.SetName(text(std::string(name_mark).c_str()));
  header.SetTimeStamp(text("1970-01-01T00:00:00"));
  header.SetAuthorValue(1, text(""));
  header.SetOrganizationValue(1, text(""));
  header.SetPreprocessorVersion(text("Planish"));
  header.SetOriginatingSystem(text("Planish"));
  header.SetAuthorisation(text(""));
  header.SetDescriptionValue(1, text("Planish model"));
  header.Apply(model);
}

void replace_all(std::string& in, std::string_view what, std::string_view with) {
  for (std::size_t at = in.find(what); at != std::string::npos; at = in.find(what, at)) {
    in.replace(at, what.size(), with);
    at += with.size();
  }
}

/// Takes one code point off the front of UTF-8 text.
char32_t next_code_point(std::string_view& rest) {
  constexpr char32_t unknown = 0xFFFD;
  const auto first = static_cast<unsigned char>(rest[0]);
  rest.remove_prefix(1);
  if (first < 0x80) return first;
  const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC2 ? 1 : 0;
  if (more == 0 || first > 0xF4) return unknown;
  char32_t point = first & (0x3Fu >> more);
  for (int i = 0; i < more; ++i) {
    if (rest.empty() || (static_cast<unsigned char>(rest[0]) & 0xC0u) != 0x80u) return unknown;
    point = point << 6 | (static_cast<unsigned char>(rest[0]) & 0x3Fu);
    rest.remove_prefix(1);
  }
  return point;
}

}  // namespace

std::string step_string(const std::string& utf8) {
  std::string out;
  for (std::string_view rest = utf8; !rest.empty();) {
    const char32_t c = next_code_point(rest);
    if (c == '\'' || c == '\\')
      out.append(2, static_cast<char>(c));
    else if (c >= 0x20 && c < 0x7F)
      out += static_cast<char>(c);
    else if (c < 0x10000)
      out += fmt::format("\\X2\\{:04X}\\X0\\", static_cast<unsigned>(c));
    else
      out += fmt::format("\\X4\\{:08X}\\X0\\", static_cast<unsigned>(c));
  }
  return out;
}

Result<std::string> step_text(const TopoDS_Shape& shape, const std::string& name) {
  const auto lock = exchange_lock();
  STEPControl_Writer writer;  // registers the parameters, so it comes first
  set_parameters();
  if (writer.Transfer(large_faces_last(shape), STEPControl_AsIs) != IFSelect_RetDone)
    return fail(refuse::no_translation, {}, name);
  const Handle(StepData_StepModel) model = writer.Model();
  set_product_name(model);
  set_header(model);

  StepData_StepWriter out(model);
  out.SendModel(Handle(StepData_Protocol)::DownCast(model->Protocol()));
  std::ostringstream stream;
  if (!out.Print(stream)) return fail(refuse::no_print, {}, name);
  std::string result = stream.str();
  replace_all(result, name_mark, step_string(name));
  return result;
}

}  // namespace planish::brep
