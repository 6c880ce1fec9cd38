#pragma once

#include <array>
#include <string>
#include <vector>

namespace meshknit {

/// How much a problem matters: a note says what was mended, a warning leaves the result usable,
/// an error does not.
enum class Severity { note, warning, error };

/// The places a problem is about. Vertices, edges (as vertex pairs) and faces are those of the
/// arrays that the caller handed in; boundaries and nodes are indices into the result they come
/// from.
struct ProblemElements {
  std::vector<int> vertices;
  std::vector<std::array<int, 2>> edges;
  std::vector<int> faces;
  std::vector<int> boundaries;
  std::vector<int> nodes;
  std::vector<int> stitches;
  std::vector<int> lines;  ///< lines of a knitout file, counted from 1
};

/// One thing that is wrong, for a person: what (message), where (elements), what to change
/// (remedy). `code` is stable and in lower-case-with-dashes, for tests and scripts.
struct Problem {
  std::string code;
  Severity severity = Severity::error;
  std::string message;
  std::string remedy;
  ProblemElements elements;
};

using Problems = std::vector<Problem>;

/// True if any problem is an error.
bool has_errors(const Problems& problems);

/// The first problem with this code, or nullptr.
const Problem* find_problem(const Problems& problems, const std::string& code);

}  // namespace meshknit
