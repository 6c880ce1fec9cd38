#include "meshknit/surface/orientation.h"

#include <algorithm>

#include "meshknit/surface/disjoint_sets.h"

namespace meshknit {
namespace {

// The faces beside each face, with whether the two run along their edge the same way.
struct Neighbour {
  int face = -1;
  bool disagrees = false;
};
using Neighbours = std::vector<std::array<Neighbour, 3>>;

Neighbours neighbours(const FaceList& faces, const std::vector<FaceSide>& sides) {
  Neighbours result(faces.corners.size());
  for_each_edge(sides, [&](auto first, auto last) {
    if (last - first != 2) return;
    const FaceSide &one = *first, &two = *(first + 1);
    const bool disagrees = one.forward == two.forward;
    result[one.face][one.corner] = {two.face, disagrees};
    result[two.face][two.corner] = {one.face, disagrees};
  });
  return result;
}

// Walks over one piece; returns its faces and sets which would have to be turned to agree with
// the first.
std::vector<int> walk_piece(const Neighbours& beside, int start, int piece, Orientation& result,
                            std::vector<bool>& turned) {
  std::vector<int> faces = {start};
  result.piece[start] = piece;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (const Neighbour& next : beside[faces[i]]) {
      if (next.face < 0 || result.piece[next.face] >= 0) continue;
      result.piece[next.face] = piece;
      turned[next.face] = turned[faces[i]] != next.disagrees;
      faces.push_back(next.face);
    }
  return faces;
}

int corner_of(const FaceList& faces, int face, int vertex) {
  const auto& c = faces.corners[face];
  return 3 * face + static_cast<int>(std::find(c.begin(), c.end(), vertex) - c.begin());
}

}  // namespace

Orientation orient_faces(FaceList& faces, const std::vector<FaceSide>& sides) {
  const std::size_t count = faces.corners.size();
  Orientation result;
  result.piece.assign(count, -1);
  const Neighbours beside = neighbours(faces, sides);
  std::vector<bool> turned(count, false);
  for (std::size_t f = 0; f < count; ++f) {
    if (result.piece[f] >= 0) continue;
    const auto piece = walk_piece(beside, static_cast<int>(f), result.pieces++, result, turned);
    const auto minority =
        std::count_if(piece.begin(), piece.end(), [&](int g) { return turned[g]; });
    if (2 * minority > static_cast<std::ptrdiff_t>(piece.size()))
      for (const int g : piece) turned[g] = !turned[g];
  }
  for_each_edge(sides, [&](auto first, auto last) {
    if (last - first != 2) return;
    const bool agree = (first->forward != turned[first->face]) !=
                       ((first + 1)->forward != turned[(first + 1)->face]);
    if (!agree) result.contradictions.push_back({first->a, first->b});
  });
  for (std::size_t f = 0; f < count; ++f)
    if (turned[f]) {
      std::swap(faces.corners[f][1], faces.corners[f][2]);
      result.flipped.push_back(static_cast<int>(f));
    }
  return result;
}

std::vector<int> pinched_vertices(const FaceList& faces, const std::vector<FaceSide>& sides) {
  DisjointSets fans(3 * faces.corners.size());
  for_each_edge(sides, [&](auto first, auto last) {
    if (last - first != 2) return;
    for (const int vertex : {first->a, first->b})
      fans.unite(corner_of(faces, first->face, vertex),
                 corner_of(faces, (first + 1)->face, vertex));
  });
  std::vector<std::array<int, 2>> vertex_fan;  // one entry a fan
  for (std::size_t f = 0; f < faces.corners.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int corner = static_cast<int>(3 * f) + k;
      if (fans.root(corner) == corner) vertex_fan.push_back({faces.corners[f][k], corner});
    }
  std::sort(vertex_fan.begin(), vertex_fan.end());
  std::vector<int> pinched;
  for (std::size_t i = 1; i < vertex_fan.size(); ++i)
    if (vertex_fan[i][0] == vertex_fan[i - 1][0] &&
        (pinched.empty() || pinched.back() != vertex_fan[i][0]))
      pinched.push_back(vertex_fan[i][0]);
  return pinched;
}

}  // namespace meshknit
