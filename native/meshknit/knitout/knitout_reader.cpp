#include "meshknit/knitout/knitout_reader.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "meshknit/knitout/knitout_operations.h"
#include "meshknit/knitout/knitout_tokens.h"

namespace meshknit {
namespace {

class Reader {
 public:
  KnitoutText read(std::string_view text) {
    if (!is_utf8(text)) {
      complain("not-utf8", 1, "The file is not UTF-8 text.", "Write the file as UTF-8.");
    }
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      ++line_;
      read_line(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (line_ == 0) check_first_line("");
    if (!has_carriers_) {
      complain("no-carriers-header", 1, "The file has no \";;Carriers:\" header.",
               "Name the machine's carriers, front to back, in a Carriers header.");
    }
    return std::move(result_);
  }

 private:
  void read_line(std::string_view line) {
    if (!line.empty() && line.back() == '\r') {
      if (!carriage_return_) {
        complain("bad-line-end", line_, "Lines end with a carriage return.",
                 "Write the file with plain line feeds.");
      }
      carriage_return_ = true;
      line.remove_suffix(1);
    }
    if (line_ == 1) return check_first_line(line);
    if (line.substr(0, 2) == ";;" && line.find(": ", 2) != std::string_view::npos) {
      if (in_headers_) return read_header(line.substr(2));
      complain("late-header", line_, "A header after the first other line is only a comment.",
               "Move it up to the headers.", Severity::warning);
    }
    in_headers_ = false;
    read_operation(line);
  }

  void check_first_line(std::string_view line) {
    if (line == ";!knitout-2") return;
    complain("bad-first-line", 1, "The first line is not \";!knitout-2\".",
             "Begin the file with that line.");
  }

  void read_header(std::string_view header) {
    const std::size_t colon = header.find(": ");
    const std::string name(header.substr(0, colon));
    const std::string value(trimmed(header.substr(colon + 2)));
    const auto& others = result_.program.headers;
    const bool twice = (name == "Carriers" && has_carriers_) ||
                       std::any_of(others.begin(), others.end(),
                                   [&](const auto& other) { return other.first == name; });
    if (twice) {
      return complain("duplicate-header", line_, "Header \"" + name + "\" stands twice.",
                      "Keep one of the two.");
    }
    if (name == "Carriers") return read_carriers(value);
    if (name == "Position" && !is_position(value)) {
      return complain("bad-header", line_, "\"" + value + "\" is no position.",
                      "Use Left, Center, Right or Keep.");
    }
    const bool known = name == "Machine" || name == "Gauge" || name == "Position" ||
                       name == "Width" || name.compare(0, 5, "Yarn-") == 0;
    if (!known) {
      complain("unknown-header", line_, "Header \"" + name + "\" is not known.",
               "It was kept and changes nothing.", Severity::warning);
    }
    result_.program.headers.emplace_back(name, value);
  }

  void read_carriers(std::string_view value) {
    has_carriers_ = true;
    auto& carriers = result_.program.carriers;
    for (const std::string_view word : split_words(value)) {
      if (word.find_first_of(",;") != std::string_view::npos ||
          std::find(carriers.begin(), carriers.end(), word) != carriers.end()) {
        complain("bad-header", line_, "Carrier \"" + std::string(word) + "\" cannot be used.",
                 "Name every carrier once, separated by spaces, without comma or semicolon.");
        continue;
      }
      carriers.emplace_back(word);
    }
  }

  void read_operation(std::string_view line) {
    const std::size_t semicolon = std::min(line.find(';'), line.size());
    const std::vector<std::string_view> words = split_words(line.substr(0, semicolon));
    if (words.empty()) return;
    std::optional<OperationComplaint> complaint;
    std::optional<Instruction> instruction =
        parse_operation(words, has_carriers_ ? &result_.program.carriers : nullptr, complaint);
    if (complaint) {
      complain(complaint->code, line_,
               "Line " + std::to_string(line_) + ": " + complaint->message + ".",
               complaint->warning ? "It was kept and changes nothing." : "Correct the line.",
               complaint->warning ? Severity::warning : Severity::error);
    }
    if (!instruction) return;
    instruction->line = line_;
    if (semicolon < line.size()) {
      instruction->source = parse_source(line.substr(semicolon + 1));
    }
    result_.program.instructions.push_back(std::move(*instruction));
  }

  void complain(std::string code, int line, std::string message, std::string remedy,
                Severity severity = Severity::error) {
    Problem problem;
    problem.code = std::move(code);
    problem.severity = severity;
    problem.message = std::move(message);
    problem.remedy = std::move(remedy);
    problem.elements.lines = {line};
    result_.problems.push_back(std::move(problem));
  }

  KnitoutText result_;
  int line_ = 0;
  bool in_headers_ = true;
  bool has_carriers_ = false;
  bool carriage_return_ = false;
};

}  // namespace

KnitoutText read_knitout(std::string_view text) { return Reader().read(text); }

}  // namespace meshknit
