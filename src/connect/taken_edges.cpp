#include "taken_edges.hpp"

#include "outline_run.hpp"

namespace planish::connect_detail {

void take(const BendFit& fit, const std::vector<PlacedPlate>& plates, TakenEdges& taken) {
  for (std::size_t side = 0; side < fit.report.plates.size(); ++side) {
    const int p = fit.report.plates[side];
    take(plates[p], fit.runs[side], taken[p].whole, taken[p].parts);
  }
}

void take(const BendBand& band, const std::vector<int>& rows,
          const std::vector<PlacedPlate>& plates, TakenEdges& taken) {
  for (std::size_t side = 0; side < rows.size(); ++side) {
    UsedEdges& used = taken[rows[side]];
    take(plates[rows[side]], band.runs[side], used.whole, used.parts);
    for (const OutlineRun& run : band.more[side])
      take(plates[rows[side]], run, used.whole, used.parts);
  }
}

FitTask task_of(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
                const TakenEdges& taken, const std::vector<int>& rows, const BendRequest& request) {
  FitTask task;
  task.request = request;
  task.thickness = structure.thickness;
  for (std::size_t side = 0; side < rows.size(); ++side) {
    task.plates[side] = &plates[rows[side]];
    task.taken[side] = taken[rows[side]].whole;
    task.taken_parts[side] = taken[rows[side]].parts;
  }
  return task;
}

Parts parts_of(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
               std::size_t bends) {
  Parts parts{structure.thickness, plates, {}, std::vector<BendFit>(bends), 0};
  for (const Plate& plate : structure.plates)
    parts.ids.push_back(plate.id);
  return parts;
}

}  // namespace planish::connect_detail
