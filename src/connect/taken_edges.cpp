#include "taken_edges.hpp"

#include "outline_run.hpp"

namespace planish::connect_detail {

void take(const BendFit& fit, const std::vector<PlacedPlate>& plates, TakenEdges& taken) {
  for (std::size_t side = 0; side < fit.report.plates.size(); ++side) {
    const int p = fit.report.plates[side];
    take(plates[p], fit.runs[side], taken[p]);
  }
}

void take(const BendBand& band, const std::vector<int>& rows,
          const std::vector<PlacedPlate>& plates, TakenEdges& taken) {
  for (std::size_t side = 0; side < rows.size(); ++side) {
    const int p = rows[side];
    take(plates[p], band.runs[side], taken[p]);
    for (const OutlineRun& run : band.more[side])
      take(plates[p], run, taken[p]);
  }
}

TakenEdges taken_by(const Parts& parts, const BendFit* but) {
  TakenEdges taken(parts.plates.size());
  for (const BendFit& fit : parts.fits) {
    if (&fit == but) continue;
    take(fit, parts.plates, taken);
    for (const BendBand& band : fit.stretches)
      take(band, fit.report.plates, parts.plates, taken);
  }
  return taken;
}

FitTask task_of(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
                const TakenEdges& taken, const std::vector<int>& rows, const BendRequest& request) {
  FitTask task;
  task.request = request;
  task.thickness = structure.thickness;
  for (std::size_t side = 0; side < rows.size(); ++side) {
    task.plates[side] = &plates[rows[side]];
    task.taken[side] = taken[rows[side]];
  }
  return task;
}

Parts parts_of(const PlateStructure& structure, const std::vector<PlacedPlate>& plates,
               std::size_t bends) {
  return {structure.thickness, plates, mapped(structure.plates, &Plate::id),
          std::vector<BendFit>(bends), 0};
}

}  // namespace planish::connect_detail
