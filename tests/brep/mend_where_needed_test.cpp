#include "mend_where_needed.hpp"

#include "exchange_lock.hpp"
#include "step_out.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <XSAlgo.hxx>
#include <gtest/gtest.h>

#include <sstream>

namespace planish::brep {
namespace {

MendCount count_of_reading(const TopoDS_Shape& shape) {
  const auto text = step_text(shape, "part");
  const auto lock = exchange_lock();
  const MendWhereNeeded mending;
  STEPControl_Reader reader;
  std::istringstream stream(*text);
  EXPECT_EQ(reader.ReadStream("part", stream), IFSelect_RetDone);
  reader.TransferRoots();
  return mending.count();
}

TEST(MendWhereNeeded, CountsTheShapesAndTheFacesThatItMends) {
  const MendCount box = count_of_reading(BRepPrimAPI_MakeBox(30, 20, 2).Shape());
  EXPECT_EQ(box.shapes, 1);
  EXPECT_EQ(box.faces, 0);
  EXPECT_EQ(box.whole, 0);
  const MendCount dimpled = count_of_reading(
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(30, 20, 2).Shape(),
                      BRepPrimAPI_MakeSphere(gp_Pnt(9, 9, 2), 1.5).Shape()));
  EXPECT_EQ(dimpled.shapes, 1);
  EXPECT_EQ(dimpled.faces, 1) << "part of a sphere is written without its curves";
  EXPECT_EQ(dimpled.whole, 0);
}

TEST(MendWhereNeeded, CountsWhatItMendsAsAWhole) {
  BRep_Builder builder;
  TopoDS_Shell five;
  TopoDS_Solid open;
  builder.MakeShell(five);
  int left = 5;
  for (TopExp_Explorer faces(BRepPrimAPI_MakeBox(30, 20, 2).Shape(), TopAbs_FACE); faces.More();
       faces.Next())
    if (left-- > 0) builder.Add(five, faces.Current());
  five.Closed(true);  // as the file says
  builder.MakeSolid(open);
  builder.Add(open, five);
  const MendCount count = count_of_reading(open);
  EXPECT_EQ(count.shapes, 1);
  EXPECT_EQ(count.whole, 1);
}

TEST(MendWhereNeeded, CountsEveryShapeOfAFile) {
  BRep_Builder builder;
  TopoDS_Compound three;
  builder.MakeCompound(three);
  for (int i = 0; i < 3; ++i)
    builder.Add(three, BRepPrimAPI_MakeBox(gp_Pnt(50 * i, 0, 0), 30, 20, 2).Solid());
  const MendCount boxes = count_of_reading(three);
  EXPECT_EQ(boxes.shapes, 3);
  EXPECT_EQ(boxes.faces, 0);
}

TEST(MendWhereNeeded, GivesTheKernelItsOwnMendingBack) {
  const auto lock = exchange_lock();
  XSAlgo::Init();
  const Handle(XSAlgo_AlgoContainer) before = XSAlgo::AlgoContainer();
  {
    const MendWhereNeeded mending;
    EXPECT_NE(XSAlgo::AlgoContainer(), before);
    EXPECT_EQ(mending.count().shapes, 0);
  }
  EXPECT_EQ(XSAlgo::AlgoContainer(), before);
}

}  // namespace
}  // namespace planish::brep
