#include "knit_graph/knit_graph_text.h"

#include <algorithm>
#include <charconv>

#include "meshknit/core/error.h"

namespace meshknit {
namespace {

void put(std::string& text, double value) {
  // The shortest digits that read back to the same number, whatever the locale.
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  text.append(1, ' ').append(digits, end);
}

void put(std::string& text, int value) { text.append(1, ' ').append(std::to_string(value)); }

/// The words of one line, taken one after another.
class LineReader {
 public:
  LineReader(std::string_view line, int number)
      : rest_(line.substr(0, line.find('#'))), number_(number) {}

  bool at_end() {
    skip_spaces();
    return rest_.empty();
  }

  std::string_view word() {
    if (at_end()) fail("ends too early");
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kSpaces));
    rest_.remove_prefix(word.size());
    return word;
  }

  template <typename Number>
  Number number() {
    return parse<Number>(word());
  }

  template <typename Number>
  Number parse(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
      fail("has \"" + std::string(text) + "\" where a number belongs");
    return value;
  }

  void expect_end() {
    if (!at_end()) fail("goes on after its last number");
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw InvalidInput("knit graph text: line " + std::to_string(number_) + " " + what);
  }

 private:
  static constexpr std::string_view kSpaces = " \t\r";

  void skip_spaces() {
    const std::size_t start = rest_.find_first_not_of(kSpaces);
    rest_.remove_prefix(start == std::string_view::npos ? rest_.size() : start);
  }

  std::string_view rest_;
  int number_;
};

void read_row(LineReader& line, bool closed, KnitGraph& graph) {
  KnitRow row;
  row.closed = closed;
  std::vector<double> lengths;
  for (;;) {
    const std::string_view word = line.word();
    if (word == "lengths") break;
    row.nodes.push_back(line.parse<int>(word));
  }
  while (!line.at_end()) lengths.push_back(line.number<double>());
  graph.rows.push_back(std::move(row));
  graph.row_lengths.push_back(std::move(lengths));
}

void read_line(LineReader& line, KnitGraph& graph) {
  const std::string_view what = line.word();
  if (what == "stitch") {
    graph.stitch_width = line.number<double>();
    graph.stitch_height = line.number<double>();
  } else if (what == "node") {
    KnitNode node;
    for (int axis = 0; axis < 3; ++axis) node.position[axis] = line.number<double>();
    node.time = line.number<double>();
    graph.nodes.push_back(node);
  } else if (what == "closed" || what == "short") {
    read_row(line, what == "closed", graph);
  } else if (what == "column") {
    const int from = line.number<int>();
    const int to = line.number<int>();
    graph.columns.push_back({from, to});
    graph.column_lengths.push_back(line.number<double>());
  } else {
    line.fail("begins with \"" + std::string(what) + "\", which is not known");
  }
  line.expect_end();
}

}  // namespace

std::string write_knit_graph(const KnitGraph& graph) {
  std::string text = "knit-graph 1\nstitch";
  put(text, graph.stitch_width);
  put(text, graph.stitch_height);
  for (const KnitNode& node : graph.nodes) {
    text += "\nnode";
    for (int axis = 0; axis < 3; ++axis) put(text, node.position[axis]);
    put(text, node.time);
  }
  for (std::size_t r = 0; r < graph.rows.size(); ++r) {
    text += graph.rows[r].closed ? "\nclosed" : "\nshort";
    for (const int node : graph.rows[r].nodes) put(text, node);
    text += " lengths";
    for (const double length : graph.row_lengths[r]) put(text, length);
  }
  for (std::size_t k = 0; k < graph.columns.size(); ++k) {
    text += "\ncolumn";
    put(text, graph.columns[k][0]);
    put(text, graph.columns[k][1]);
    put(text, graph.column_lengths[k]);
  }
  return text + "\n";
}

KnitGraph read_knit_graph(std::string_view text) {
  KnitGraph graph;
  bool has_title = false;
  for (int number = 1; !text.empty(); ++number) {
    const std::string_view content = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), content.size() + 1));
    LineReader line(content, number);
    if (line.at_end()) continue;
    if (has_title) {
      read_line(line, graph);
      continue;
    }
    if (line.word() != "knit-graph" || line.number<int>() != 1)
      line.fail("should be \"knit-graph 1\"");
    line.expect_end();
    has_title = true;
  }
  if (!has_title) throw InvalidInput("knit graph text: line 1 should be \"knit-graph 1\"");
  return graph;
}

}  // namespace meshknit
