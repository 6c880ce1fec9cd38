#include "meshknit/surface/opening_regions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "meshknit/surface/face_region.h"
#include "meshknit/surface/level_cut.h"
#include "meshknit/surface/point_distance.h"

namespace meshknit {
namespace {

constexpr double pi = 3.14159265358979323846;

// Edges by the rim, as a part of the radius: a circle of 150 to 250 sides.
constexpr double fineness = 1.0 / 12.0;
// Crossings nearer to a vertex than this part of their edge go through it: with that fineness an
// error of less than 1.3 % of the radius.
constexpr double snap = 0.15;
// A place may be this far from the surface: in radii, and as a part of the bounding box.
constexpr double farthest_radii = 2.0, farthest_part = 0.1;
// No circle on a surface of people's is longer than this many times 2 pi r.
constexpr double longest_circle = 3.0;

double diagonal(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto v : mesh.vertices()) box.extend(mesh.point(v));
  return box.diagonal().norm();
}

}  // namespace

OpeningRegions::OpeningRegions(const Surface& checked)
    : surface(checked), mesh(checked.mesh), origin(checked.mesh.n_faces()) {
  for (std::size_t f = 0; f < origin.size(); ++f) origin[f].face = static_cast<int>(f);
}

void OpeningRegions::cut_mark(const OpeningMark& mark, double shortest) {
  regions.push_back({{}, name_of(mark), mark.radius, 0.0});
  regions.back().opening.mark = static_cast<int>(regions.size()) - 1;
  OpeningName& name = regions.back().name;
  if (!(mark.radius > 0.0) || !std::isfinite(mark.radius) || !mark.at.allFinite()) {
    problems.push_back(opening_radius(name));
    return;
  }
  SurfacePoint place = nearest_face(mesh, mark.at);
  name.elements.faces = {surface.source_face[origin[place.face].face]};
  const double off = (place.position - mark.at).norm();
  if (off > farthest_radii * mark.radius || off > farthest_part * diagonal(surface.mesh)) {
    problems.push_back(opening_off_surface(name, off));
    return;
  }
  const double circle = 2.0 * pi * mark.radius;
  if (longest_circle * circle < shortest) {
    problems.push_back(opening_too_small(name, circle, shortest, 1.02 * shortest / (2.0 * pi)));
    return;
  }
  refine_near(mesh, origin, place, 1.05 * mark.radius, fineness * mark.radius);
  place = nearest_face(mesh, place.position);
  std::vector<double> distance = distance_from(mesh, place, 1.25 * mark.radius);
  regions.back().length_before = line_length(mesh, distance, 0.9 * mark.radius);
  cut_along_level(mesh, origin, distance, mark.radius, snap);
  label_disc(faces_within(mesh, distance, mark.radius));
}

void OpeningRegions::label_disc(const std::vector<int>& faces) {
  const int index = static_cast<int>(regions.size()) - 1;
  const OpeningName& name = regions[index].name;
  std::vector<char> inside(mesh.n_faces(), 0);
  for (const int f : faces) inside[f] = 1;
  const RegionShape shape = region_shape(mesh, faces, inside);
  const auto taken =
      std::find_if(faces.begin(), faces.end(), [&](int f) { return origin[f].opening >= 0; });
  if (shape.rims == 0)
    problems.push_back(opening_swallows_part(name));
  else if (shape.at_boundary)
    problems.push_back(opening_over_boundary(name));
  else if (taken != faces.end())
    problems.push_back(openings_overlap(regions[origin[*taken].opening].name, name));
  else if (shape.characteristic != 1 || shape.rims != 1)
    problems.push_back(opening_not_a_disc(name, shape.rims));
  else
    for (const int f : faces) origin[f].opening = index;
}

void OpeningRegions::leave_out(const std::vector<int>& face_marks) {
  std::vector<int> number(origin.size());
  for (std::size_t f = 0; f < number.size(); ++f)
    number[f] = face_marks[surface.source_face[origin[f].face]];
  const bool all = std::count(number.begin(), number.end(), 0) == 0;
  for (const std::vector<int>& island : islands(mesh, number)) {
    Opening opening;
    opening.face_mark = number[island.front()];
    int overlapped = -1;
    for (const int f : island) {
      opening.faces.push_back(surface.source_face[origin[f].face]);
      overlapped = std::max(overlapped, origin[f].opening);
    }
    // Rims of other openings may have split a face into several.
    std::sort(opening.faces.begin(), opening.faces.end());
    opening.faces.erase(std::unique(opening.faces.begin(), opening.faces.end()),
                        opening.faces.end());
    const OpeningName name = name_of_faces(
        opening.faces, mesh.calc_face_centroid(OpenMesh::FaceHandle(island.front())));
    const int index = static_cast<int>(regions.size());
    if (all)
      problems.push_back(opening_swallows_part(name));
    else if (overlapped >= 0)
      problems.push_back(openings_overlap(regions[overlapped].name, name));
    else
      for (const int f : island) origin[f].opening = index;
    regions.push_back({std::move(opening), name, 0.0, 0.0});
  }
}

void OpeningRegions::check_touching() {
  std::vector<char> left_out(origin.size());
  for (std::size_t f = 0; f < origin.size(); ++f) left_out[f] = origin[f].opening >= 0;
  std::vector<char> told(regions.size(), 0);
  for (const auto v : mesh.vertices()) {
    int one = -1, other = -1;
    for (const auto f : mesh.vf_range(v)) {
      const int opening = origin[f.idx()].opening;
      if (opening < 0 || opening == one) continue;
      (one < 0 ? one : other) = opening;
    }
    if (one < 0) continue;
    if (other >= 0 && one > other) std::swap(one, other);
    if (other >= 0 ? told[other] : told[one] || !pinched_at(mesh, v, left_out)) continue;
    told[std::max(one, other)] = 1;
    problems.push_back(other >= 0 ? openings_touch(regions[one].name, regions[other].name)
                                  : opening_not_a_disc(regions[one].name, 1));
  }
}

}  // namespace meshknit
