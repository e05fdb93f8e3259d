#pragma once

#include "outline.hpp"

#include <dxflib/dl_dxf.h>

#include <string>

namespace planish::io_detail {

/// dxflib's writer with a string in place of the file. Reals are written as the shortest decimal
/// that reads back as the same double, without exponent; magnitudes below 1e-15 become 0.
class DxfWriter final : public DL_WriterA {
 public:
  explicit DxfWriter(DxfVersion version);

  bool r12() const { return version < DL_VERSION_2000; }
  const std::string& text() const { return text_; }

  void dxfReal(int code, double value) const override;
  void dxfInt(int code, int value) const override;
  void dxfHex(int code, int value) const override;
  void dxfString(int code, const char* value) const override;
  void dxfString(int code, const std::string& value) const override;

 private:
  mutable std::string text_;  // dxflib's interface writes through const functions
};

DL_Codes::version dxflib_version(DxfVersion version);

/// Properties of an entity besides its geometry; colours are AutoCAD's numbers.
struct EntityStyle {
  std::string layer;
  int color = 7;
  bool dashed = false;
  bool off = false;  ///< the layer is not shown until somebody switches it on
};

/// The DASHED linetype, mm: a dash and a gap.
constexpr double kDash = 12.7;
constexpr double kGap = 6.35;

/// Everything up to the first entity.
struct DxfProlog {
  Box2 extents;
  LengthUnit units = LengthUnit::mm;
  std::vector<EntityStyle> layers;
};
void write_prolog(DL_Dxf& dxf, DxfWriter& writer, const DxfProlog& prolog);
void write_epilog(DL_Dxf& dxf, DxfWriter& writer);

/// `dash_scale` shortens the dashes of a line too short to show any.
void write_line(DxfWriter& writer, const EntityStyle& style, const Segment& line,
                double dash_scale);
/// A line of text, its middle `at`, turned counter-clockwise; "°" and "×" are written as DXF and
/// its fonts have them, other characters beyond ASCII as \U+XXXX.
struct DxfText {
  Vec2 at;
  double height = 0.0;  ///< of capitals
  Angle turned;
  std::string text;
};
void write_text(DxfWriter& writer, const EntityStyle& style, const DxfText& text);
void write_outline(DxfWriter& writer, const EntityStyle& style, const Outline& outline);

}  // namespace planish::io_detail
