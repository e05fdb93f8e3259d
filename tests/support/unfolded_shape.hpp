#pragma once

#include "guarded.hpp"
#include "step_out.hpp"

#include <planish/brep/step.hpp>
#include <planish/sheet/certificate.hpp>

#include <TopoDS_Shape.hxx>

#include <string>

namespace planish::test {

/// A kernel's shape, written as STEP and read again, unfolded with K = ½.
struct UnfoldedShape {
  Sheet sheet;
  FlatPattern flat;
  Certificate certificate;
};

/// The sheet in the only body of STEP text.
inline Result<Recognized> recognized_text(const std::string& text,
                                          const RecognizeOptions& options = {}) {
  const auto file = read_step_text(text, "part.step");
  if (!file) return tl::unexpected(file.error());
  return recognize(file->bodies.front(), options);
}

inline Result<Recognized> recognized_shape(const TopoDS_Shape& shape,
                                           const RecognizeOptions& options = {}) {
  const auto text = brep::guarded([&] { return brep::step_text(shape, "part"); });
  if (!text) return tl::unexpected(text.error());
  return recognized_text(*text, options);
}

inline Result<UnfoldedShape> unfolded_sheet(Result<Recognized> found) {
  if (!found) return tl::unexpected(found.error());
  auto flat = flatten(found->sheet, {.allowance = ConstantK{0.5, "test"}});
  if (!flat) return tl::unexpected(flat.error());
  auto certificate = certify(found->sheet, *flat, found->distance);
  if (!certificate) return tl::unexpected(certificate.error());
  return UnfoldedShape{std::move(found->sheet), std::move(*flat), *certificate};
}

inline Result<UnfoldedShape> unfolded_shape(const TopoDS_Shape& shape,
                                            const RecognizeOptions& options = {}) {
  return unfolded_sheet(recognized_shape(shape, options));
}

}  // namespace planish::test
