#pragma once

#include <planish/geometry/frame.hpp>

#include <BRep_Builder.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Vertex.hxx>

#include <vector>

namespace planish::brep {

/// An edge, whose curve runs over the parameter 0 … length from `start` to `end`.
struct BuiltEdge {
  TopoDS_Edge edge;
  Handle(Geom_Curve) curve;
  double length = 0.0;
  TopoDS_Vertex start, end;
};

/// An edge as a face's loop uses it, with its curve in the face's surface (null on planes).
struct EdgeUse {
  const BuiltEdge* edge = nullptr;
  Handle(Geom2d_Curve) curve;
  bool forward = true;
};

/// Builds vertices, edges and faces with valid tolerances: every edge's covers the distance of its
/// curve from its curves in the surfaces, every vertex's covers those of its edges.
class SolidBuilder {
 public:
  TopoDS_Vertex vertex(const Vec3& point);
  BuiltEdge edge(const Handle(Geom_Curve) & curve, double length, const TopoDS_Vertex& start,
                 const TopoDS_Vertex& end);
  BuiltEdge straight_edge(const TopoDS_Vertex& start, const TopoDS_Vertex& end);

  /// Adds a face. Loops run counter-clockwise seen from `outside`: +1 the tip of the surface's
  /// normal, −1 its opposite. An edge used twice by one loop is a seam.
  void face(const Handle(Geom_Surface) & surface, int outside,
            const std::vector<std::vector<EdgeUse>>& loops);

  /// All faces as one closed shell.
  TopoDS_Shell shell() const;
  /// Faces, by the number of their call of `face`, as a shell with free edges.
  TopoDS_Shell open_shell(const std::vector<int>& faces) const;

 private:
  void attach(const EdgeUse& use, const Handle(Geom_Surface) & surface);
  void loosen(const BuiltEdge& edge, double deviation);

  BRep_Builder builder_;
  std::vector<TopoDS_Face> faces_;
};

}  // namespace planish::brep
