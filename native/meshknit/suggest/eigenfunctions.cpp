#include "meshknit/suggest/eigenfunctions.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "meshknit/time_field/laplacian.h"

namespace meshknit {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

constexpr int rounds = 12;

Eigen::VectorXd vertex_areas(const TriangleMesh& mesh) {
  Eigen::VectorXd area = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.n_vertices()));
  for (const auto f : mesh.faces()) {
    const double third = mesh.calc_face_area(f) / 3.0;
    for (const auto v : mesh.fv_range(f)) area[v.idx()] += third;
  }
  return area;
}

// L + shift M: positive definite, so that it can be factored once.
Matrix shifted_laplacian(const TriangleMesh& mesh, const Eigen::VectorXd& area, double shift) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const EdgeWeight& w : laplacian_weights(mesh, LaplacianKind::clamped_cotangent)) {
    entries.emplace_back(w.a, w.a, w.weight);
    entries.emplace_back(w.b, w.b, w.weight);
    entries.emplace_back(w.b, w.a, -w.weight);
  }
  for (Eigen::Index v = 0; v < area.size(); ++v)
    entries.emplace_back(static_cast<int>(v), static_cast<int>(v), shift * area[v]);
  Matrix matrix(area.size(), area.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Without the constant part and what earlier columns hold, all of mean square 1.
void orthonormalise(const Eigen::VectorXd& area, Eigen::MatrixXd& columns) {
  const double all = area.sum();
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    columns.col(k).array() -= area.dot(columns.col(k)) / all;
    for (Eigen::Index j = 0; j < k; ++j)
      columns.col(k) -=
          (columns.col(j).cwiseProduct(area)).dot(columns.col(k)) / all * columns.col(j);
    const double square = (columns.col(k).cwiseProduct(area)).dot(columns.col(k)) / all;
    if (square > 0.0) columns.col(k) /= std::sqrt(square);
  }
}

}  // namespace

std::vector<std::vector<double>> low_eigenfunctions(const TriangleMesh& mesh, int count,
                                                    RunContext* run) {
  const auto n = static_cast<Eigen::Index>(mesh.n_vertices());
  const Eigen::VectorXd area = vertex_areas(mesh);
  // Far below the first eigenvalue of any shape of this area, which is of the order of 1 / area.
  const Matrix system = shifted_laplacian(mesh, area, 0.01 / area.sum());
  const Eigen::SimplicialLDLT<Matrix> factor(system);
  report(run, 0.0);
  // One more than asked for: the last one converges slowly. Begin with mixtures of the coordinates
  // and their products, so that no symmetry of the shape leaves one of them out.
  const Eigen::Index k = count + 1;
  Eigen::Vector3d low = mesh.point(TriangleMesh::VertexHandle(0)), high = low;
  for (const auto v : mesh.vertices()) {
    low = low.cwiseMin(mesh.point(v));
    high = high.cwiseMax(mesh.point(v));
  }
  const double size = std::max((high - low).maxCoeff(), 1e-12);
  Eigen::MatrixXd columns(n, k);
  for (Eigen::Index v = 0; v < n; ++v) {
    const Eigen::Vector3d p =
        (mesh.point(TriangleMesh::VertexHandle(static_cast<int>(v))) - 0.5 * (low + high)) /
        size;
    const std::array<double, 6> start = {p.x(),         p.y(),         p.z(),
                                         p.x() * p.y(), p.y() * p.z(), p.z() * p.x()};
    for (Eigen::Index j = 0; j < k; ++j) {
      columns(v, j) = 0.0;
      for (std::size_t i = 0; i < start.size(); ++i)
        columns(v, j) +=
            std::sin(static_cast<double>((i + 1) * static_cast<std::size_t>(2 * j + 3))) *
            start[i];
    }
  }
  orthonormalise(area, columns);
  for (int round = 0; round < rounds; ++round) {
    report(run, 0.0);
    columns = factor.solve(area.asDiagonal() * columns).eval();
    orthonormalise(area, columns);
  }
  // The best combinations of what was found (Rayleigh and Ritz).
  const Eigen::MatrixXd applied = system.selfadjointView<Eigen::Lower>() * columns;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> small(columns.transpose() * applied);
  columns = (columns * small.eigenvectors()).eval();
  std::vector<std::vector<double>> functions;
  for (Eigen::Index j = 0; j < count; ++j) {
    Eigen::Index largest = 0;
    columns.col(j).cwiseAbs().maxCoeff(&largest);
    const double sign = columns(largest, j) < 0.0 ? -1.0 : 1.0;
    functions.emplace_back(static_cast<std::size_t>(n));
    for (Eigen::Index v = 0; v < n; ++v)
      functions.back()[static_cast<std::size_t>(v)] = sign * columns(v, j);
  }
  return functions;
}

}  // namespace meshknit
