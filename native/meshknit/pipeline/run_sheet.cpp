#include "meshknit/pipeline/run_sheet.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "meshknit/knitout/knitout_reader.h"
#include "meshknit/pipeline/knit_parts.h"
#include "meshknit/pipeline/part_seams.h"
#include "meshknit/pipeline/seam_problems.h"

namespace meshknit {
namespace {

constexpr int kLongWait = 60;  // passes; then joins show
constexpr double kMillimetresPerInch = 25.4;

std::string several(int count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " and ") + words[i];
  return text;
}

class Sheet {
 public:
  Sheet(const StitchTrace& trace, const CheckedKnitout& file, const MachineProfile& profile,
        const std::vector<Seam>& seams)
      : trace_(trace),
        file_(file),
        profile_(profile),
        seams_(seams),
        program_(read_knitout(file.text).program),
        parts_(find_parts(program_, trace, profile)),
        sewn_(find_part_seams(seams, parts_, program_, trace)) {}

  std::string write() {
    machine();
    carriers();
    parts();
    finishing();
    if (!sewn_.empty()) sewing();
    warnings();
    return std::move(text_);
  }

 private:
  void line(const std::string& text) { text_ += text + "\n"; }

  void fact(const std::string& name, const std::string& value) {
    line(name + std::string(12 - name.size(), ' ') + value);
  }

  void heading(const std::string& name) {
    line("");
    line(name);
    line(std::string(name.size(), '-'));
  }

  void machine() {
    const ProgramCost& cost = file_.cost;
    const int span = cost.highest_needle - cost.lowest_needle + 1;
    line("Run sheet");
    line("=========");
    line("");
    fact("Machine", profile_.name + ", " + std::to_string(profile_.gauge) +
                        " needles an inch, " + std::to_string(profile_.needles) +
                        " needles a bed, every second one used");
    fact("On the bed",
         "needles " + std::to_string(cost.lowest_needle) + " to " +
             std::to_string(cost.highest_needle) + ": " + std::to_string(span) + " needles, " +
             std::to_string(std::lround(span * kMillimetresPerInch / profile_.gauge)) + " mm");
    fact("Stitches", std::to_string(trace_.stitches.size()));
    fact("Passes", std::to_string(cost.passes) + ", " + several(cost.transfers, "transfer") +
                       ", racking up to " + std::to_string(std::lround(cost.max_racking)));
    if (file_.kcode_sweeps > 0)
      fact("", std::to_string(file_.kcode_sweeps) + " sweeps of the carriage in the .kc file");
    fact("Time", "about " + std::to_string(std::max(1L, std::lround(cost.estimated_minutes))) +
                     " minutes");
  }

  void carriers() {
    heading("Carriers");
    std::map<std::string, int> times_in;
    for (const Instruction& i : program_.instructions)
      if (i.op == Op::in || i.op == Op::inhook) ++times_in[i.carriers.front()];
    for (const std::string& carrier : profile_.carriers) {
      const int times = times_in[carrier];
      std::string holds = "empty";
      if (times > 0 && carrier == profile_.waste_carrier)
        holds = "waste: any yarn of the object's thickness";
      else if (times > 0 && carrier == profile_.draw_carrier)
        holds = "draw thread: smooth and strong";
      else if (times > 0)
        holds = "yarn of the object, for " + parts_of(carrier);
      if (times > 1) holds += "; comes in " + std::to_string(times) + " times";
      line("  " + carrier + std::string(carrier.size() < 3 ? 3 - carrier.size() : 0, ' ') +
           " " + holds);
    }
  }

  std::string parts_of(const std::string& carrier) const {
    std::vector<std::string> numbers;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      const std::vector<std::string>& own = parts_[p].carriers;
      if (std::find(own.begin(), own.end(), carrier) != own.end())
        numbers.push_back(std::to_string(p + 1));
    }
    return (numbers.size() == 1 ? "part " : "parts ") + joined(numbers);
  }

  std::string named(const std::vector<int>& tubes) const {
    std::vector<std::string> numbers;
    for (std::size_t p = 0; p < parts_.size(); ++p)
      if (std::find(tubes.begin(), tubes.end(), parts_[p].tube) != tubes.end())
        numbers.push_back(std::to_string(p + 1));
    return joined(numbers);
  }

  void parts() {
    heading("Parts, in the order in which they begin");
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      const KnitPart& part = parts_[p];
      std::string text = "  " + std::to_string(p + 1) + "  line " + std::to_string(part.line) +
                         ", needles " + std::to_string(part.lowest) + " to " +
                         std::to_string(part.highest) + ": ";
      text += part.starts > 0 ? "starts with " + several(part.starts, "loop") + " on waste"
                              : "goes on from " + named(part.from);
      if (part.ends > 0) text += ", ends with " + several(part.ends, "loop") + " under waste";
      if (part.into.size() > 1) text += ", parts into " + named(part.into);
      if (part.into.size() == 1) text += ", goes into " + named(part.into);
      line(text);
    }
  }

  void finishing() {
    heading("To finish");
    const bool draw = !profile_.draw_carrier.empty();
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      const std::string part = "part " + std::to_string(p + 1);
      if (parts_[p].starts > 0)
        line("  Below " + part + " " +
             (draw ? "pull the draw thread" : "cut the waste and pull it out") + "; " +
             several(parts_[p].starts, "loop") +
             " of the object come free: " + what_to_do(is_sewn(p, &PartSeam::upper)));
      if (parts_[p].ends > 0)
        line("  Above " + part + " unravel the waste down to the object; " +
             several(parts_[p].ends, "loop") +
             " come free: " + what_to_do(is_sewn(p, &PartSeam::lower)));
    }
    line("  Cut the yarn wherever a carrier went away or came back, and weave in " +
         several(2 * trace_.yarns, "end") + ".");
    if (!profile_.has_inserting_hook && parts_.size() > 1)
      line(
          "  Carriers come from the left: the ends of parts further right run through those "
          "left of them. Cut them there.");
    if (parts_.size() > 1)
      line(std::string("  Parts are joined where they part and meet: ") +
           (sewn_.empty() ? "no seams." : "no seams but those below."));
  }

  bool is_sewn(std::size_t part, int PartSeam::*side) const {
    return std::any_of(sewn_.begin(), sewn_.end(), [&](const PartSeam& seam) {
      return seam.*side == static_cast<int>(part);
    });
  }

  static std::string what_to_do(bool sewn) {
    return sewn ? "keep them on a thread, to be sewn."
                : "bind them off, or sew the opening shut.";
  }

  void sewing() {
    heading("To sew");
    for (std::size_t i = 0; i < sewn_.size(); ++i) {
      const PartSeam& seam = sewn_[i];
      line("  The end of part " + std::to_string(seam.lower + 1) + ", " +
           several(seam.lower_loops, "loop") + ", to the beginning of part " +
           std::to_string(seam.upper + 1) + ", " + several(seam.upper_loops, "loop") +
           ": round the tube at " + place_of(seams_[i]) +
           " on the object. Begin with the loop that is made in line " +
           std::to_string(seam.lower_line) + " and the one of line " +
           std::to_string(seam.upper_line) + ", and go round both the same way.");
    }
  }

  void warnings() {
    heading("To watch");
    const std::size_t before = text_.size();
    std::vector<std::string> codes;
    for (const Problem& p : file_.check.problems)
      if (p.severity == Severity::warning &&
          std::find(codes.begin(), codes.end(), p.code) == codes.end())
        codes.push_back(p.code);
    for (const std::string& code : codes) warning(code);
    for (std::size_t p = 0; p < parts_.size(); ++p)
      if (parts_[p].longest_wait > kLongWait)
        line("  Part " + std::to_string(p + 1) + ": loops wait for " +
             std::to_string(parts_[p].longest_wait) + " passes, until line " +
             std::to_string(parts_[p].wait_line) +
             ". They are stretched: see that they stay on "
             "their needles.");
    if (text_.size() == before) line("  Nothing unusual.");
  }

  // The first of its kind, and how many more there are.
  void warning(const std::string& code) {
    const Problems& all = file_.check.problems;
    const auto count =
        std::count_if(all.begin(), all.end(), [&](const Problem& p) { return p.code == code; });
    const Problem& first = *find_problem(all, code);
    const int more = static_cast<int>(count) - 1;
    line("  " + first.message + (more > 0 ? " And " + several(more, "more place") + "." : "") +
         " " + first.remedy);
  }

  const StitchTrace& trace_;
  const CheckedKnitout& file_;
  const MachineProfile& profile_;
  const std::vector<Seam>& seams_;
  Program program_;
  std::vector<KnitPart> parts_;
  std::vector<PartSeam> sewn_;  // [seam]
  std::string text_;
};

}  // namespace

std::string write_run_sheet(const StitchTrace& trace, const CheckedKnitout& file,
                            const MachineProfile& profile, const std::vector<Seam>& seams) {
  return Sheet(trace, file, profile, seams).write();
}

}  // namespace meshknit
