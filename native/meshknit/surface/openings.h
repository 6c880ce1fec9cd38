#pragma once

#include <vector>

#include "meshknit/core/problem.h"
#include "meshknit/surface/surface.h"

namespace meshknit {

/// An opening to be cut: the surface within `radius` mm of a place, measured along the surface.
struct OpeningMark {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< mm, on or near the surface
  double radius = 0.0;                           ///< mm
};

/// An opening that was cut.
struct Opening {
  int mark = -1;            ///< index into the marks; -1 for marked faces
  int face_mark = 0;        ///< what its faces were marked with; 0 for a mark
  std::vector<int> faces;   ///< rows of the input's faces that were marked; empty for a mark
  std::vector<int> rim;     ///< rows of the new vertices in order, the surface on their left
  double rim_length = 0.0;  ///< mm
};

/// A surface without its openings.
struct CutSurface {
  VertexArray vertices;
  FaceArray faces;
  std::vector<int> source_vertex;     ///< new vertex -> row of the input; -1 for those on a cut
  std::vector<int> vertex_of_source;  ///< row of the input -> new vertex, the same for doubled
                                      ///< ones; -1 if it was left out
  std::vector<int> source_face;       ///< new face -> row of the input
  std::vector<Opening> openings;  ///< of the marks in their order, then islands of marked faces
                                  ///< in the order of their first faces
  Problems problems;
};

/// Cuts openings out of a mesh (mm). `face_marks` has a number a face, or none at all: faces with
/// a number other than 0 are left out, and those with the same number that hang together are an
/// opening. Marks are cut along the line of equal distance, through the triangles: rim vertices
/// lie on the surface, and their distance from the place is that of the radius within 2 %,
/// however coarse the mesh. Distances are those of the whole surface, so openings do not depend
/// on each other. Marked faces may reach over a boundary, which then moves, or take away a whole
/// piece ("part-left-out", a note); a mark may not.
///
/// Mends like make_surface and says so in notes. Errors: those of make_surface that leave no
/// mesh, "opening-radius", "opening-off-surface" (further than two radii or a tenth of the
/// object), "opening-too-small" (rim shorter than the shortest row), "opening-too-large" (the
/// same, beyond the widest place), "opening-swallows-part", "opening-over-boundary",
/// "opening-not-a-disc" (several rims, or one that touches itself), "openings-overlap",
/// "openings-touch". They name vertices and faces of the input. With an error the arrays are
/// those of the input and `openings` is empty. Bad geometry never throws.
/// Throws: InvalidInput if a face names a vertex that is not there, or `face_marks` has another
/// length than the faces.
/// Ensures: new vertices come after those of the input, which keep their order and place. Faces
/// lie in their source faces. A mark makes Euler's characteristic less by one.
CutSurface cut_openings(const VertexArray& vertices, const FaceArray& faces,
                        const std::vector<int>& face_marks,
                        const std::vector<OpeningMark>& marks,
                        const SurfaceOptions& options = {});

/// Which of these promises a result breaks: "cut-moved-vertex", "cut-off-surface",
/// "cut-rim-not-boundary", "cut-rim-distance", "cut-characteristic". Empty for results with
/// errors.
Problems check_cut(const VertexArray& vertices, const FaceArray& faces,
                   const std::vector<OpeningMark>& marks, const CutSurface& cut);

}  // namespace meshknit
