#include "body.hpp"
#include "brep_text.hpp"
#include "coordinate_bound.hpp"
#include "exchange_lock.hpp"
#include "guarded.hpp"
#include "identical.hpp"
#include "packed_file.hpp"
#include "product_tree.hpp"
#include "refusals.hpp"
#include "step_header.hpp"

#include <planish/base/text.hpp>
#include <planish/brep/step_archive.hpp>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_TShape.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

// Bodies of a STEP file: all placed solids of its product tree, the same shape in several places
// being one body with several places. Solids of one material that agree by their fingerprint
// (identical.cpp) are merged too: copies that a file spells out. That looks at every edge, so it
// comes last and tells its progress.

namespace planish {
namespace {

using brep::Fingerprint;
using brep::guarded;

/// Share of the time that reading takes before bodies are compared, of parts of 2 to 4 MB.
constexpr double kTranslated = 0.9;

/// Distinct bodies among solids: the same shape in another place is the same body once more.
class BodyCollector {
 public:
  explicit BodyCollector(const std::vector<brep::PlacedSolid>& solids) {
    std::map<const TopoDS_TShape*, size_t> known;
    for (const brep::PlacedSolid& one : solids) {
      const auto [at, fresh] = known.emplace(one.solid.TShape().get(), rows_.size());
      if (!fresh) {
        ++rows_[at->second].shape.quantity;
        continue;
      }
      TopTools_IndexedMapOfShape faces;
      TopExp::MapShapes(one.solid, TopAbs_FACE, faces);
      rows_.push_back({{one.solid, one.name, 1, faces.Extent(), one.material.name, one.colour,
                        one.material.density},
                       {}});
    }
  }

  std::vector<Body> take(const Progress& progress) && {
    merge_congruent(progress);
    std::vector<Body> bodies;
    for (Row& row : rows_) {
      if (row.shape.name.empty()) row.shape.name = fmt::format("body-{}", bodies.size() + 1);
      bodies.emplace_back(std::make_shared<const Body::Shape>(std::move(row.shape)));
    }
    return bodies;
  }

 private:
  struct Row {
    Body::Shape shape;
    Fingerprint fingerprint;
  };

  void merge_congruent(const Progress& progress) {
    if (rows_.size() < 2) return;
    std::vector<Row> distinct;
    for (Row& row : rows_) {
      if (progress.should_stop()) return;
      const double share = static_cast<double>(&row - rows_.data()) /
                           static_cast<double>(rows_.size());
      progress.at("comparing bodies", std::lerp(kTranslated, 1.0, share));
      row.fingerprint = brep::fingerprint_of(row.shape.solid);
      const auto same = std::ranges::find_if(distinct, [&](const Row& known) {
        return known.shape.material == row.shape.material &&
               brep::identical(known.fingerprint, row.fingerprint);
      });
      if (same == distinct.end())
        distinct.push_back(std::move(row));
      else
        same->shape.quantity += row.shape.quantity;
    }
    rows_ = std::move(distinct);
  }

  std::vector<Row> rows_;
};

Result<brep::ProductTree> tree_in(const std::string& text, const std::string& path,
                                  const std::string& name, const Progress& progress) {
  if (brep::is_kernel_shape(text)) return brep::read_kernel_shape(text, name);
  std::istringstream stream(text);
  return brep::read_products(stream, path, name, progress);
}

/// `path` is the file's path: files that it refers to are sought beside it.
Result<StepFile> transfer(const std::string& text, const std::string& path, const std::string& name,
                          const Progress& progress) {
  return guarded(
      [&]() -> Result<StepFile> {
        const auto lock = brep::exchange_lock();
        const auto tree = tree_in(text, path, name, progress);
        if (!tree) return pass_on(tree);
        StepFile file;
        file.bodies = BodyCollector(tree->solids).take(progress);
        file.surface_bodies = tree->surface_bodies;
        file.unit = tree->unit;
        file.content = tree->content;
        if (progress.should_stop()) return fail(refuse::reading_stopped, {{"file", name}}, name);
        return file;
      },
      name);
}

Result<StepFile> check_bodies(StepFile file, const std::string& name) {
  if (!file.bodies.empty()) return file;
  if (file.surface_bodies > 0)
    return fail(refuse::surfaces_only, {{"file", name}, {"count", file.surface_bodies}}, name);
  return fail(refuse::no_solid, {{"file", name}}, name);
}

Result<StepFile> read_checked(const std::string& text, const std::string& path,
                              const std::string& name, const Progress& progress) {
  const auto header = brep::is_kernel_shape(text) ? brep::StepHeader{"B-rep of OpenCASCADE", ""}
                                                  : brep::read_step_header(text, name);
  if (!header) return pass_on(header);
  auto content = transfer(text, path, name, progress);
  if (!content) return content;
  content->schema = header->schema;
  content->cad_system = header->cad_system;
  return check_bodies(std::move(*content), name);
}

/// The same of a file that may be packed, or begin with a byte order mark, which the kernel does
/// not know.
Result<StepFile> read_any(const std::string& bytes, const std::string& path,
                          const std::string& name, const Progress& progress) {
  if (const auto plain = without_byte_order_mark(bytes); plain.size() < bytes.size())
    return read_checked(std::string(plain), path, name, progress);
  if (!brep::is_packed(bytes)) return read_checked(bytes, path, name, progress);
  const auto text = brep::unpacked(bytes, path);  // whose sentences name files in an archive
  if (!text) return pass_on(text);
  if (brep::is_packed(*text)) return fail(refuse::not_step, {{"file", name}}, name);
  return read_any(*text, path, name, progress);
}

}  // namespace

Result<StepFile> read_step(const std::filesystem::path& file, const Progress& progress) {
  const std::string name = file.filename().string();
  if (is_in_archive(file)) {
    const auto text = read_in_archive(file);
    return text ? read_any(*text, name, name, progress) : pass_on(text);
  }
  std::error_code status;
  if (std::filesystem::is_directory(file, status))
    return fail(refuse::is_folder, {{"file", file.string()}}, file.string());
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    return fail(refuse::cannot_open,
                {{"file", file.string()},
                 {"why", std::filesystem::exists(file, status) ? "permission denied"
                                                               : "there is no such file"}},
                file.string());
  std::ostringstream text;
  text << stream.rdbuf();
  return read_any(std::move(text).str(), file.string(), name, progress);
}

Result<StepFile> read_step_text(const std::string& text, const std::string& name,
                                const Progress& progress) {
  return read_any(text, name, name, progress);
}

}  // namespace planish
