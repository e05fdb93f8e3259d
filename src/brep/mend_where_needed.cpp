#include "mend_where_needed.hpp"

#include <XSAlgo.hxx>

namespace planish::brep {
namespace {

/// The place where the kernel's reader hands each shape to its mending.
class Processing : public XSAlgo_AlgoContainer {
 public:
  TopoDS_Shape ProcessShape(const TopoDS_Shape& shape, Standard_Real precision,
                            Standard_Real largest_tolerance, Standard_CString, Standard_CString,
                            Handle(Standard_Transient) &, const Message_ProgressRange&,
                            Standard_Boolean) const override {
    if (shape.IsNull()) return shape;
    const Mended done = mended(shape, {precision, largest_tolerance});
    ++count.shapes;
    count.faces += done.faces;
    count.whole += done.whole ? 1 : 0;
    return done.shape;
  }

  mutable MendCount count;
};

}  // namespace

MendWhereNeeded::MendWhereNeeded() {
  XSAlgo::Init();
  before_ = XSAlgo::AlgoContainer();
  ours_ = new Processing;
  XSAlgo::SetAlgoContainer(ours_);
}

MendWhereNeeded::~MendWhereNeeded() { XSAlgo::SetAlgoContainer(before_); }

const MendCount& MendWhereNeeded::count() const {
  return static_cast<const Processing&>(*ours_).count;
}

}  // namespace planish::brep
