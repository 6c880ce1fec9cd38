// Other people's meshes (models.h); skipped where they are not.

#include <gtest/gtest.h>

#include <filesystem>

#include "mesh_files.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/remesh/remesh.h"
#include "models.h"
#include "shapes.h"

namespace meshknit {
namespace {

class EveryModel : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(ModelGraphs, EveryModel, testing::ValuesIn(model_names()),
                         [](const auto& name) { return name.param; });

TEST_P(EveryModel, CanBeKnit) {
  const std::optional<ExampleShape> drawn = model(GetParam());
  if (!drawn) GTEST_SKIP() << why_no_models();
  const TimedShape shape = timed(opened(*drawn));
  const KnitGraph graph = remesh(shape.surface, shape.time);
  for (const Problem& problem : check_knit_graph(graph).problems)
    EXPECT_NE(problem.severity, Severity::error) << problem.message;
  const KnitGraphStats stats = measure_graph(graph);
  EXPECT_EQ(stats.splits + stats.merges,
            check_time_field(shape.surface, shape.time).expected_saddles);
  // A node covers l_r x 2 l_c of the surface.
  const double wanted = shape.surface.area / (3.66 * 3.46);
  EXPECT_NEAR(stats.nodes, wanted, 0.1 * wanted);
  EXPECT_GE(stats.row_error.within_10, 0.97);
  EXPECT_GE(stats.row_error.within_20, 0.99);
  // Also where two openings leave every limb of a toy to short rows.
  EXPECT_GE(stats.column_error.within_10, 0.93);
  EXPECT_GE(stats.column_error.within_20, 0.99);
}

struct Refused {
  const char *file, *code;
};

TEST(ModelGraphs, WhatIsNoSurfaceIsRefusedWithItsReason) {
  for (const auto& [file, code] :
       {Refused{"moebius_nonorientable.obj", "not-orientable"},
        Refused{"hourglass_nonmanifold_vertex.obj", "nonmanifold-vertex"}}) {
    if (!std::filesystem::exists(model_path(file))) GTEST_SKIP() << why_no_models();
    const MeshArrays arrays = read_mesh_file(model_path(file), 10.0);
    const Surface surface = make_surface(arrays.vertices, arrays.faces);
    EXPECT_TRUE(has_errors(surface.problems));
    EXPECT_NE(find_problem(surface.problems, code), nullptr) << file;
  }
}

}  // namespace
}  // namespace meshknit
