#include <algorithm>
#include <optional>
#include <utility>

#include "meshknit/knitout/kcode.h"
#include "meshknit/knitout/knitout_tokens.h"

namespace meshknit {
namespace {

/// A FRNT or REAR line: needles at work, and the stops in their order along the line.
struct BedLine {
  std::vector<int> needles;
  int carrier = 0;
  std::vector<int> carriage_stops, carrier_stops;
};

class Reader {
 public:
  explicit Reader(int needles) : needles_(needles) {}

  KcodeText read(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      ++line_;
      read_line(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (line_ == 0) complain("The file is empty");
    if (has_front_ || has_rear_) complain("The last pass is not finished");
    check_turns();
    return std::move(result_);
  }

 private:
  void read_line(std::string_view line) {
    const auto begins = [&](std::string_view with) {
      return line.substr(0, with.size()) == with;
    };
    if (line_ == 1) {
      if (line != "HOME") complain("The file does not begin with HOME");
    } else if (begins("//") || line.empty()) {
      return;
    } else if (begins("RACK:")) {
      read_racking(line.substr(5));
    } else if (begins("FRNT:")) {
      begin_pass(line.substr(5));
    } else if (begins("REAR:")) {
      has_rear_ = read_bed(line.substr(5), rear_);
    } else if (begins("STIF:")) {
      read_sizes(line.substr(5), pass_.front_size);
    } else if (begins("STIR:")) {
      read_sizes(line.substr(5), pass_.rear_size);
    } else if (begins(">> ") || begins("<< ")) {
      pass_.direction = line[0] == '>' ? Side::right : Side::left;
      finish_pass(split_words(line.substr(3)));
    } else {
      complain("The line cannot be understood");
    }
  }

  void read_racking(std::string_view value) {
    const std::optional<double> racking = parse_decimal(value);
    if (!racking) return complain("The racking is no number");
    racking_ = *racking;
  }

  void begin_pass(std::string_view bed) {
    pass_ = {};
    pass_.line = line_;
    has_rear_ = false;
    has_front_ = read_bed(bed, front_);
  }

  bool read_bed(std::string_view text, BedLine& bed) {
    bed = {};
    int column = 0;
    for (const char c : text) {
      if (c == '/' || c == '\\') {
        bed.carriage_stops.push_back(column);
      } else if (c >= '1' && c <= '9') {
        if (bed.carrier != 0 && bed.carrier != c - '0') return broken("A bed has two carriers");
        bed.carrier = c - '0';
        bed.carrier_stops.push_back(column);
      } else if (c == '.' || c == '_' || c == '-') {
        const bool beside = column < kColumnsBeside || column >= kColumnsBeside + needles_;
        if ((c == '.') != beside) return broken("A bed does not lie where it should");
        if (c == '-') bed.needles.push_back(column - kColumnsBeside + 1);
        ++column;
      } else {
        return broken("A bed has a sign that is not known");
      }
    }
    if (column != needles_ + 2 * kColumnsBeside) return broken("A bed has a wrong length");
    if (bed.carriage_stops.size() != 2 || (bed.carrier != 0) != (bed.carrier_stops.size() == 2))
      return broken("A bed has a wrong number of stops");
    return true;
  }

  void read_sizes(std::string_view text, char& size) {
    if (text.size() != static_cast<std::size_t>(needles_ + 2 * kColumnsBeside))
      return complain("A line of sizes has a wrong length");
    if (text.find_first_not_of(text[0]) != std::string_view::npos)
      return complain("Sizes differ along the bed");
    size = text[0];
  }

  void finish_pass(const std::vector<std::string_view>& words) {
    if (!std::exchange(has_front_, false) || !std::exchange(has_rear_, false))
      return complain("The pass has no beds");
    const bool same_stops = front_.carriage_stops == rear_.carriage_stops &&
                            front_.carrier == rear_.carrier &&
                            front_.carrier_stops == rear_.carrier_stops;
    if (!same_stops) return complain("Front and rear bed name different stops");
    if (words.size() != 4 || !read_cams(words[0]))
      return complain("The pass is not \"cams carrier speed roller\"");
    const std::optional<int> carrier = parse_integer(words[1]), speed = parse_integer(words[2]),
                             roller = parse_integer(words[3]);
    if (!carrier || !speed || !roller) return complain("Carrier, speed or roller is no number");
    if (*carrier != front_.carrier) return complain("The carrier is not the one on the beds");
    pass_.carrier = *carrier;
    pass_.speed = *speed;
    pass_.roller = *roller;
    pass_.racking = racking_;
    pass_.front = std::move(front_.needles);
    pass_.rear = std::move(rear_.needles);
    pass_.carriage_left = front_.carriage_stops[0];
    pass_.carriage_right = front_.carriage_stops[1];
    if (pass_.carrier > 0) {
      pass_.carrier_left = front_.carrier_stops[0];
      pass_.carrier_right = front_.carrier_stops[1];
    }
    if (pass_.kind != KcodePass::Kind::yarn && !face_each_other())
      return complain("The transfer's needles do not face each other");
    result_.passes.push_back(std::move(pass_));
  }

  bool read_cams(std::string_view cams) {
    using Kind = KcodePass::Kind;
    const bool right = pass_.direction == Side::right;
    if (cams == (right ? "Tr-Rr" : "Tr-Rl")) {
      pass_.kind = Kind::front_to_back;
      return true;
    }
    if (cams == (right ? "Rr-Tr" : "Rl-Tr")) {
      pass_.kind = Kind::back_to_front;
      return true;
    }
    if (cams.size() != 5 || cams[2] != '-') return false;
    const auto tucks = [](std::string_view half) -> std::optional<bool> {
      if (half == "Tu") return true;
      if (half == "Kn") return false;
      return std::nullopt;
    };
    const auto front = tucks(cams.substr(0, 2)), rear = tucks(cams.substr(3));
    if (!front || !rear) return false;
    pass_.front_tucks = *front;
    pass_.rear_tucks = *rear;
    return true;
  }

  bool face_each_other() const {
    if (pass_.carrier != 0 || pass_.front.size() != pass_.rear.size()) return false;
    for (std::size_t k = 0; k < pass_.front.size(); ++k)
      if (pass_.front[k] != pass_.rear[k] + pass_.racking) return false;
    return true;
  }

  void check_turns() {
    const std::vector<KcodePass>& all = result_.passes;
    if (!all.empty() && all[0].direction != Side::right)
      complain("The carriage starts on the left", all[0].line);
    for (std::size_t p = 0; p < all.size(); ++p) {
      const KcodePass& pass = all[p];
      if (pass.carriage_left >= pass.carriage_right)
        complain("The carriage stops before it starts", pass.line);
      const bool carrier_inside =
          pass.carrier == 0 ||
          (pass.carriage_left <= pass.carrier_left && pass.carrier_left <= pass.carrier_right &&
           pass.carrier_right <= pass.carriage_right);
      if (!carrier_inside) complain("The carrier goes further than the carriage", pass.line);
      if (p == 0) continue;
      const KcodePass& before = all[p - 1];
      if (before.direction == pass.direction)
        complain("The carriage goes the same way twice", pass.line);
      else if (pass.direction == Side::left ? before.carriage_right != pass.carriage_right
                                            : before.carriage_left != pass.carriage_left)
        complain("The carriage does not start where it stopped", pass.line);
    }
  }

  bool broken(const std::string& what) {
    complain(what);
    return false;
  }

  void complain(const std::string& what) { complain(what, line_); }

  void complain(const std::string& what, int line) {
    Problem problem;
    problem.code = "bad-kcode";
    problem.message = "Line " + std::to_string(line) + ": " + what + ".";
    problem.remedy = "Write the .kc file anew.";
    problem.elements.lines = {line};
    result_.problems.push_back(std::move(problem));
  }

  int needles_;
  KcodeText result_;
  KcodePass pass_;
  BedLine front_, rear_;
  bool has_front_ = false, has_rear_ = false;
  double racking_ = 0.0;
  int line_ = 0;
};

}  // namespace

KcodeText read_kcode(std::string_view text, int needles) { return Reader(needles).read(text); }

}  // namespace meshknit
