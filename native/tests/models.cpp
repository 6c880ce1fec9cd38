#include "models.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "mesh_files.h"
#include "meshknit/core/error.h"

namespace meshknit {
namespace {

// Of an opening (radius in mm), or, without a radius, of the boundary that is there.
struct Place {
  double x, y, z;  // units of the file
  double radius, time;
};

struct Model {
  const char* name;
  const char* file;
  double scale;  // mm per unit
  std::vector<Place> places;
};

const std::vector<Model>& models() {
  static const std::vector<Model> all = {
      {"pants",
       "mh_pants.obj",
       100.0,
       {{0.0, 0.85, 0.0, 0.0, -1.0}, {-1.5, -7.4, 0.0, 0.0, 1.0}, {1.5, -7.4, 0.0, 0.0, 1.0}}},
      {"tshirt",
       "mh_tshirt.obj",
       100.0,
       {{0.0, 2.8, 0.3, 0.0, -1.0},
        {-2.7, 3.6, 0.0, 0.0, 1.0},
        {2.7, 3.6, 0.0, 0.0, 1.0},
        {0.0, 5.4, 0.2, 0.0, 1.0}}},
      {"skirt",
       "mh_skirt.obj",
       100.0,
       {{0.0, -7.3, 0.0, 0.0, -1.0}, {0.0, 1.8, 0.0, 0.0, 1.0}}},
      {"glove",
       "hand_glove.obj",
       201.3,
       {{0.0, 0.0, 0.0, 0.0, -1.0},
        {-0.41, 0.55, 0.14, 4.5, 0.6},
        {-0.13, 0.91, 0.05, 4.5, 1.0},
        {0.04, 0.95, 0.04, 4.5, 1.0},
        {0.17, 0.86, 0.05, 4.5, 1.0},
        {0.32, 0.69, 0.11, 4.5, 0.8}}},
      {"spot",
       "spot.obj",
       112.7,
       {{-0.3, -0.74, 0.05, 9.0, -1.0},
        {0.3, -0.74, 0.05, 9.0, -1.0},
        {-0.3, -0.74, 0.85, 9.0, -1.0},
        {0.3, -0.74, 0.85, 9.0, -1.0},
        {0.0, 0.3, -0.75, 14.0, 1.0}}},
      {"spot_two",
       "spot.obj",
       112.7,
       {{0.0, -0.1, 1.1, 20.0, -1.0}, {0.0, 0.3, -0.75, 14.0, 1.0}}},
      {"stuffedtoy",
       "stuffedtoy.obj",
       277.8,
       {{-0.1, 0.0, 0.05, 12.0, -1.0},
        {0.1, 0.0, 0.05, 12.0, -1.0},
        {-0.47, 0.67, 0.0, 9.0, 1.0},
        {0.45, 0.67, 0.0, 9.0, 1.0},
        {0.0, 0.86, -0.03, 14.0, 1.0}}},
      {"stuffedtoy_two",
       "stuffedtoy.obj",
       277.8,
       {{-0.1, 0.0, 0.05, 12.0, -1.0}, {0.0, 0.86, -0.03, 14.0, 1.0}}},
      {"bob",
       "bob_genus1.ply",
       80.8,
       {{0.95, 0.2, 0.0, 9.0, -1.0}, {-0.95, 0.15, 0.0, 9.0, 1.0}}},
  };
  return all;
}

}  // namespace

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  for (const Model& entry : models()) names.push_back(entry.name);
  return names;
}

std::string why_no_models() {
  return "Other people's meshes may not be copied into the project, and there are none at " +
         model_path("") +
         " (MESHKNIT_MODELS names their folder). The examples by name and random "
         "surfaces are knit everywhere.";
}

std::string model_path(const std::string& file) {
  const char* const folder = std::getenv("MESHKNIT_MODELS");
  return (folder ? std::string(folder)
                 : std::string(MESHKNIT_NATIVE_DIR "/../../shared/models")) +
         "/" + file;
}

std::optional<ExampleShape> model(const std::string& name) {
  const auto entry = std::find_if(models().begin(), models().end(),
                                  [&](const Model& other) { return other.name == name; });
  if (entry == models().end()) throw InvalidInput("no model is called \"" + name + "\"");
  const std::string path = model_path(entry->file);
  if (!std::filesystem::exists(path)) return std::nullopt;
  const MeshArrays arrays = read_mesh_file(path, entry->scale);
  ExampleShape shape{arrays.vertices, arrays.faces, {}, {}};
  for (const Place& place : entry->places) {
    const Eigen::Vector3d at = entry->scale * Eigen::Vector3d(place.x, place.y, place.z);
    if (place.radius > 0.0) {
      shape.times.push_back(
          {place.time, Eigen::Vector3d::Zero(), static_cast<int>(shape.openings.size())});
      shape.openings.push_back({at, place.radius});
    } else {
      shape.times.push_back({place.time, at});
    }
  }
  return shape;
}

}  // namespace meshknit
