#pragma once

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace planish::sample {

/// The pairs of a DXF text.
using Groups = std::vector<std::pair<int, std::string>>;

inline Groups groups(const std::string& text) {
  Groups result;
  std::istringstream lines(text);
  std::string code;
  std::string value;
  while (std::getline(lines, code) && std::getline(lines, value)) {
    result.emplace_back(std::stoi(code), value);
  }
  return result;
}

/// The entities of a DXF text, each from its group 0 on; vertices are entities of their own.
inline std::vector<Groups> entities(const std::string& text) {
  std::vector<Groups> result;
  bool inside = false;
  for (const auto& group : groups(text)) {
    if (group.first == 0 && group.second == "ENDSEC") inside = false;
    if (inside && group.first == 0) result.emplace_back();
    if (inside) result.back().push_back(group);
    if (group == std::pair<int, std::string>(2, "ENTITIES")) inside = true;
  }
  return result;
}

/// First value of a code, "" when there is none.
inline std::string value_of(const Groups& groups, int code) {
  for (const auto& [c, value] : groups) {
    if (c == code) return value;
  }
  return {};
}

inline std::vector<std::string> values_of(const Groups& groups, int code) {
  std::vector<std::string> values;
  for (const auto& [c, value] : groups) {
    if (c == code) values.push_back(value);
  }
  return values;
}

/// What dxflib's own reader sees.
class Reader : public DL_CreationAdapter {
 public:
  explicit Reader(const std::string& text) {
    std::istringstream stream(text);
    DL_Dxf().in(stream, this);
  }

  struct Vertex {
    double x, y, bulge;
  };
  struct Outline {
    std::string layer;
    bool closed = false;
    std::vector<Vertex> vertices;
  };
  std::vector<Outline> polylines;
  std::vector<DL_CircleData> circles;
  std::vector<DL_LineData> lines;
  std::vector<DL_ArcData> arcs;
  std::vector<DL_SplineData> splines;
  std::vector<double> knots;
  std::map<std::string, int> layers;  ///< and their colours
  std::map<std::string, int> settings;

  void addLayer(const DL_LayerData& layer) override {
    layers[layer.name] = getAttributes().getColor();
  }
  void addPolyline(const DL_PolylineData& data) override {
    polylines.push_back({getAttributes().getLayer(), (data.flags & 1) != 0, {}});
  }
  void addVertex(const DL_VertexData& v) override {
    polylines.back().vertices.push_back({v.x, v.y, v.bulge});
  }
  void addCircle(const DL_CircleData& circle) override { circles.push_back(circle); }
  void addLine(const DL_LineData& line) override { lines.push_back(line); }
  void addArc(const DL_ArcData& arc) override { arcs.push_back(arc); }
  void addSpline(const DL_SplineData& spline) override { splines.push_back(spline); }
  void addKnot(const DL_KnotData& knot) override { knots.push_back(knot.k); }
  void setVariableInt(const std::string& name, int value, int) override { settings[name] = value; }
};

/// A directory of its own, removed with what is in it.
class Directory {
 public:
  explicit Directory(const std::string& name)
      : path_(std::filesystem::temp_directory_path() /
              ("planish-" + name + "-" + std::to_string(std::hash<const void*>{}(this)) + "-" +
               std::to_string(
                   std::filesystem::file_time_type::clock::now().time_since_epoch().count()))) {
    std::filesystem::create_directories(path_);
  }
  Directory(const Directory&) = delete;
  Directory& operator=(const Directory&) = delete;
  ~Directory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A file to be checked by tools/check_dxf.py, and its area, mm².
struct Check {
  std::string text;
  double area = 0.0;
  double tolerance = 1e-9;  ///< relative
};

inline bool has_ezdxf() {
  static const bool has = std::system(PLANISH_PYTHON " -c 'import ezdxf' >/dev/null 2>&1") == 0;
  return has;
}

/// Reports of tools/check_dxf.py, one for each file, from one run.
inline nlohmann::json checked(const std::vector<Check>& checks) {
  const Directory directory("check-dxf");
  std::ofstream list(directory.path() / "list.tsv");
  list.precision(17);
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const auto path = directory.path() / (std::to_string(i) + ".dxf");
    std::ofstream(path) << checks[i].text;
    list << path.string() << '\t' << checks[i].area << '\t' << checks[i].tolerance << '\n';
  }
  list.close();
  const std::string command = std::string(PLANISH_PYTHON " " PLANISH_SOURCE_DIR) +
                              "/tools/check_dxf.py --list " +
                              (directory.path() / "list.tsv").string() + " > " +
                              (directory.path() / "report.json").string() + " 2>/dev/null";
  [[maybe_unused]] const int status = std::system(command.c_str());
  std::ifstream report(directory.path() / "report.json");
  return nlohmann::json::parse(report);
}

}  // namespace planish::sample
