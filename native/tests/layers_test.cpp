// Reads the includes of every stage and fails on one that the layer table in native/README.md does
// not allow: what comes before the knit graph knows no needles, what comes after it no triangles, and
// the check of the machine file shares nothing with what made the file.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {

const std::map<std::string, std::set<std::string>> allowed = {
    {"core", {}},
    {"surface", {"core"}},
    {"knit_graph", {"core"}},
    {"machine", {"core"}},
    {"time_field", {"core", "surface"}},
    {"tracing", {"core", "knit_graph"}},
    {"transfer", {"core", "machine"}},
    {"knitout", {"core", "machine"}},
    {"remesh", {"core", "surface", "knit_graph", "time_field"}},
    {"schedule", {"core", "knit_graph", "tracing", "machine"}},
    {"verify", {"core", "tracing", "machine", "knitout"}},
    {"emit", {"core", "tracing", "machine", "transfer", "schedule"}},
    {"suggest", {"core", "surface", "time_field", "tracing"}},
    {"pipeline",
     {"core", "surface", "time_field", "remesh", "knit_graph", "tracing", "machine", "knitout",
      "schedule", "emit", "verify"}},
};

TEST(Layers, StagesIncludeOnlyWhatTheyMayKnow) {
  namespace fs = std::filesystem;
  const fs::path stages = fs::path(MESHKNIT_NATIVE_DIR) / "meshknit";
  const std::regex include("#include \"meshknit/([a-z_]+)/");
  int seen = 0;
  for (const auto& entry : fs::recursive_directory_iterator(stages)) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
    const std::string stage = entry.path().parent_path().filename().string();
    ASSERT_TRUE(allowed.count(stage)) << stage << " is not in the layer table";
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      std::smatch match;
      if (!std::regex_search(line, match, include)) continue;
      ++seen;
      EXPECT_TRUE(match[1] == stage || allowed.at(stage).count(match[1]))
          << entry.path().filename() << " in " << stage << " includes " << match[1];
    }
  }
  EXPECT_GT(seen, 100) << "no sources found below " << stages;
}

}  // namespace
