#include "mesh_files.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <vector>

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

struct Lists {
  std::vector<double> coordinates;
  std::vector<int> corners;

  void add_polygon(const std::vector<int>& polygon) {
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      corners.insert(corners.end(), {polygon[0], polygon[i], polygon[i + 1]});
  }
};

Lists read_obj(std::istream& in) {
  Lists lists;
  for (std::string line, word; std::getline(in, line);) {
    std::istringstream words(line);
    word.clear();
    words >> word;
    if (word == "v") {
      double x = 0.0;
      for (int k = 0; k < 3 && words >> x; ++k) lists.coordinates.push_back(x);
    } else if (word == "f") {
      std::vector<int> polygon;
      // "7/2/5" starts with the vertex; the rest is about pictures and light.
      while (words >> word) polygon.push_back(std::stoi(word) - 1);
      lists.add_polygon(polygon);
    }
  }
  return lists;
}

template <class T>
T read_binary(std::istream& in) {
  char bytes[sizeof(T)] = {};
  in.read(bytes, sizeof(T));
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

Lists read_ply(std::istream& in) {
  int vertices = 0, faces = 0;
  for (std::string line, word, kind; line != "end_header" && std::getline(in, line);) {
    std::istringstream words(line);
    words >> word >> kind;
    if (word == "element") words >> (kind == "vertex" ? vertices : faces);
  }
  Lists lists;
  for (int i = 0; in && i < 3 * vertices; ++i)
    lists.coordinates.push_back(read_binary<float>(in));
  for (int i = 0; in && i < faces; ++i) {
    std::vector<int> polygon(read_binary<unsigned char>(in));
    for (int& corner : polygon) corner = read_binary<std::int32_t>(in);
    lists.add_polygon(polygon);
  }
  return lists;
}

}  // namespace

MeshArrays read_mesh_file(const std::string& path, double scale) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InvalidInput("cannot read " + path);
  const std::string ending = path.substr(path.size() - std::min<std::size_t>(4, path.size()));
  if (ending != ".obj" && ending != ".ply")
    throw InvalidInput(path + " is neither an .obj nor a .ply file");
  const Lists lists = ending == ".obj" ? read_obj(in) : read_ply(in);
  if (ending == ".ply" && !in) throw InvalidInput(path + " ends too early");
  MeshArrays arrays;
  arrays.vertices = scale * Eigen::Map<const VertexArray>(
                                lists.coordinates.data(),
                                static_cast<Eigen::Index>(lists.coordinates.size() / 3), 3);
  arrays.faces = Eigen::Map<const FaceArray>(
      lists.corners.data(), static_cast<Eigen::Index>(lists.corners.size() / 3), 3);
  return arrays;
}

}  // namespace meshknit
