#include "dxf_writer.hpp"

#include <algorithm>
#include <array>

// What stands around the entities. dxflib's own prolog shows an A4 sheet whatever the part,
// miscounts line types in R12, and lacks tables without which AutoCAD does not open an R2000 file;
// so tables are written here, with the handles that dxflib's objects section refers to.

namespace planish::io_detail {
namespace {

// The handles that dxflib's own OBJECTS section and symbol tables refer to.
constexpr int kViewportTable = 0x8;

int insertion_units(LengthUnit unit) {
  return unit == LengthUnit::mm ? 4 : unit == LengthUnit::inch ? 1 : 6;
}

void write_header(DL_Dxf& dxf, DxfWriter& w, const DxfProlog& prolog) {
  dxf.writeHeader(w);
  w.dxfString(9, "$INSUNITS");
  w.dxfInt(70, insertion_units(prolog.units));
  w.dxfString(9, "$MEASUREMENT");
  w.dxfInt(70, prolog.units == LengthUnit::inch ? 0 : 1);
  w.dxfString(9, "$EXTMIN");
  w.coord(10, prolog.extents.lo.x(), prolog.extents.lo.y());
  w.dxfString(9, "$EXTMAX");
  w.coord(10, prolog.extents.hi.x(), prolog.extents.hi.y());
  w.dxfString(9, "$LTSCALE");
  w.dxfReal(40, 1.0);
  w.sectionEnd();
}

/// The initial view: the whole part. dxflib's shows an A4 sheet, whatever the part.
void write_viewport(DxfWriter& w, const Box2& extents) {
  const Vec2 center = 0.5 * (extents.lo + extents.hi);
  const double aspect = 1.5;
  const double height = 1.1 * std::max(extents.size().y(), extents.size().x() / aspect);
  w.table("VPORT", 1, kViewportTable);
  w.dxfString(0, "VPORT");
  if (!w.r12()) {
    w.handle();
    w.subClass("AcDbSymbolTableRecord");
    w.subClass("AcDbViewportTableRecord");
  }
  w.dxfString(2, "*ACTIVE");
  w.dxfInt(70, 0);
  const auto pair = [&w](int code, double x, double y) {
    w.dxfReal(code, x);
    w.dxfReal(code + 10, y);
  };
  pair(10, 0.0, 0.0);  // the whole screen
  pair(11, 1.0, 1.0);
  pair(12, center.x(), center.y());
  pair(13, 0.0, 0.0);  // snap and grid
  pair(14, 10.0, 10.0);
  pair(15, 10.0, 10.0);
  w.coord(16, 0.0, 0.0, 1.0);  // seen from above
  w.coord(17, 0.0, 0.0);
  w.dxfReal(40, height);
  w.dxfReal(41, aspect);
  w.dxfReal(42, 50.0);  // focal length, clipping planes, angles
  for (const int code : {43, 44, 50, 51})
    w.dxfReal(code, 0.0);
  constexpr std::array<int, 8> kModes{0, 100, 1, 3, 0, 0, 0, 0};  // no snap, no grid
  for (int i = 0; i < 8; ++i)
    w.dxfInt(71 + i, kModes[i]);
  w.tableEnd();
}

void write_linetypes(DL_Dxf& dxf, DxfWriter& w, LengthUnit units) {
  const double unit = millimetres_in(units);
  std::array<double, 2> dashes{kDash / unit, -kGap / unit};
  // dxflib leaves BYBLOCK and BYLAYER out of an R12 file, but does not adjust the count.
  w.tableLinetypes(w.r12() ? 2 : 4);
  for (const char* name : {"BYBLOCK", "BYLAYER", "CONTINUOUS"}) {
    dxf.writeLinetype(w, DL_LinetypeData(name, "", 0, 0, 0.0));
  }
  dxf.writeLinetype(w, DL_LinetypeData("DASHED", "Dashed __ __ __ __ __", 0, 2,
                                       dashes[0] - dashes[1], dashes.data()));
  w.tableEnd();
}

void write_layers(DL_Dxf& dxf, DxfWriter& w, const std::vector<EntityStyle>& layers) {
  constexpr int kDefaultWidth = -3;
  w.tableLayers(static_cast<int>(layers.size()) + 1);
  dxf.writeLayer(w, DL_LayerData("0", 0), DL_Attributes("", 7, kDefaultWidth, "CONTINUOUS", 1.0));
  for (const EntityStyle& layer : layers) {
    const char* linetype = layer.dashed ? "DASHED" : "CONTINUOUS";
    dxf.writeLayer(w, DL_LayerData(layer.layer, 0, layer.off),
                   DL_Attributes("", layer.color, kDefaultWidth, linetype, 1.0));
  }
  w.tableEnd();
}

/// Tables that none of our entities needs, but without which AutoCAD does not open an R2000 file.
void write_further_tables(DL_Dxf& dxf, DxfWriter& w) {
  w.tableStyle(1);
  dxf.writeStyle(w, DL_StyleData("Standard", 0, 0.0, 1.0, 0.0, 0, 2.5, "txt", ""));
  w.tableEnd();
  dxf.writeView(w);
  dxf.writeUcs(w);
  w.tableAppid(1);
  dxf.writeAppid(w, "ACAD");
  w.tableEnd();
  dxf.writeDimStyle(w, 2.5, 1.25, 0.625, 0.625, 2.5);
  dxf.writeBlockRecord(w);
  w.tableEnd();
}

void write_blocks(DL_Dxf& dxf, DxfWriter& w) {
  w.sectionBlocks();
  if (!w.r12()) {
    // dxflib's second layout refers to the third.
    for (const char* name : {"*Model_Space", "*Paper_Space", "*Paper_Space0"}) {
      dxf.writeBlock(w, DL_BlockData(name, 0, 0.0, 0.0, 0.0));
      dxf.writeEndBlock(w, name);
    }
  }
  w.sectionEnd();
}

}  // namespace

void write_prolog(DL_Dxf& dxf, DxfWriter& w, const DxfProlog& prolog) {
  write_header(dxf, w, prolog);
  w.sectionTables();
  write_viewport(w, prolog.extents);
  write_linetypes(dxf, w, prolog.units);
  write_layers(dxf, w, prolog.layers);
  if (!w.r12()) write_further_tables(dxf, w);
  w.sectionEnd();
  write_blocks(dxf, w);
  w.sectionEntities();
}

void write_epilog(DL_Dxf& dxf, DxfWriter& w) {
  w.sectionEnd();
  if (!w.r12()) {
    dxf.writeObjects(w);
    dxf.writeObjectsEnd(w);
  }
  w.dxfEOF();
}

}  // namespace planish::io_detail
