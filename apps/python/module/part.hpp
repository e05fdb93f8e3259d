#pragma once

#include <planish/job/run.hpp>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace planish::python {

/// Numbers in rows, n × columns.
struct Rows {
  std::vector<double> numbers;
  pybind11::ssize_t columns = 2;
};

/// A read-only array of the rows, which live as long as `owner`.
pybind11::array view_of(const Rows& rows, const pybind11::object& owner);

/// The flat pattern of a piece as polygons and lines, in the unit of the report.
struct FlatRows {
  Rows outline;                ///< closed: the last point is the first
  std::vector<Rows> openings;  ///< likewise
  std::vector<Rows> slits;
  std::vector<Rows> features;   ///< outlines, closed
  std::vector<int> feature_of;  ///< by outline
  std::vector<Rows> bends;      ///< by bend, lines as rows (x0, y0, x1, y1)
};

/// A triangle mesh, mm.
class PartMesh {
 public:
  explicit PartMesh(Mesh mesh) : mesh_(std::move(mesh)) {}
  const Mesh& mesh() const { return mesh_; }

 private:
  Mesh mesh_;
};

/// What was made for a request, kept for Python. Any thread may call it.
class Part {
 public:
  explicit Part(job::MadeRequest made) : made_(std::move(made)) {}

  std::string maker() const { return std::string(made_.maker->name); }
  std::string status() const;
  std::optional<Error> refusal() const;
  /// The report as JSON text.
  std::string report() const;
  int pieces() const { return made_.made->pieces(); }
  bool has_pattern(int piece) const;

  const FlatRows& flat(int piece, double chord);
  /// The exact curves, as the text of `flat_json`.
  std::string exact(int piece) const;
  Result<Mesh> mesh();
  /// Files of an artifact, with options (a JSON object) beyond those of the request.
  Result<std::vector<job::WrittenArtifact>> write(const std::string& artifact,
                                                  const std::string& options);
  /// The pages of its bend plan.
  Result<std::string> bend_pages(bool svg);
  /// DXF of each piece for the radii that the plan's tools leave.
  Result<std::vector<std::string>> flats_as_made();
  std::vector<std::string> artifacts(const job::Catalogue& catalogue) const;

 private:
  std::mutex working_;  ///< what was made is for one thread at a time
  job::MadeRequest made_;
  std::map<std::pair<int, double>, std::unique_ptr<FlatRows>> flat_;  ///< by piece and chord
};

}  // namespace planish::python
