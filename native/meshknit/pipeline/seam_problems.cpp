#include "meshknit/pipeline/seam_problems.h"

#include <cmath>

namespace meshknit {
namespace {

void name_nodes(const KnitGraph& graph, const Seam& seam, Problem& problem) {
  for (const int row : {seam.row_below, seam.row_above})
    problem.elements.nodes.insert(problem.elements.nodes.end(), graph.rows[row].nodes.begin(),
                                  graph.rows[row].nodes.end());
}

}  // namespace

std::string place_of(const Seam& seam) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis)
    text += (axis == 0 ? "(" : ", ") + std::to_string(std::lround(seam.middle[axis]));
  return text + ") mm";
}

std::string stitches_of(const KnitGraph& graph, const Seam& seam) {
  const std::size_t below = graph.rows[seam.row_below].nodes.size();
  const std::size_t above = graph.rows[seam.row_above].nodes.size();
  return std::to_string(below) + (above != below ? " and " + std::to_string(above) : "") +
         " stitches";
}

Problem propose_seams(const KnitGraph& graph, const std::vector<Seam>& seams) {
  Problem problem;
  problem.code = "seam-needed";
  problem.severity = Severity::warning;
  problem.message = "On the machine, tubes of this object would have to cross. " +
                    (seams.size() == 1 ? std::string("One seam helps: ")
                                       : std::to_string(seams.size()) + " seams help: ");
  for (std::size_t i = 0; i < seams.size(); ++i) {
    problem.message +=
        (i == 0 ? "" : "; ") + stitches_of(graph, seams[i]) + " round " + place_of(seams[i]);
    name_nodes(graph, seams[i], problem);
  }
  problem.message += ".";
  problem.remedy = "Allow seams and sew them after knitting, or change the knitting times.";
  return problem;
}

Problems warn_of_seams(const KnitGraph& graph, const std::vector<Seam>& seams) {
  Problems problems;
  for (const Seam& seam : seams) {
    Problem problem;
    problem.code = "seam";
    problem.severity = Severity::warning;
    problem.message = "The tube round " + place_of(seam) +
                      " is knit in two parts with a seam between: " + stitches_of(graph, seam) +
                      ", row " + std::to_string(seam.row_below) + " to row " +
                      std::to_string(seam.row_above) + ", node " +
                      std::to_string(seam.columns.front()[0]) + " to node " +
                      std::to_string(seam.columns.front()[1]) + " and so on round.";
    problem.remedy = "Sew it after knitting; the run sheet says where its edges are.";
    name_nodes(graph, seam, problem);
    problems.push_back(std::move(problem));
  }
  return problems;
}

}  // namespace meshknit
