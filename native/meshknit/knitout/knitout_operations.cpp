#include "meshknit/knitout/knitout_operations.h"

#include <algorithm>
#include <array>

#include "meshknit/knitout/knitout_tokens.h"

namespace meshknit {
namespace {

using Words = std::vector<std::string_view>;

// What a line of each operation looks like.
struct Form {
  std::string_view name;
  Op op;
  bool direction;
  int needles;
  bool carriers;
  std::string_view usage;
};

constexpr std::array<Form, 13> kForms = {{
    {"in", Op::in, false, 0, true, "in CARRIERS"},
    {"inhook", Op::inhook, false, 0, true, "inhook CARRIERS"},
    {"releasehook", Op::releasehook, false, 0, true, "releasehook CARRIERS"},
    {"out", Op::out, false, 0, true, "out CARRIERS"},
    {"outhook", Op::outhook, false, 0, true, "outhook CARRIERS"},
    {"knit", Op::knit, true, 1, true, "knit DIRECTION NEEDLE CARRIERS"},
    {"tuck", Op::tuck, true, 1, true, "tuck DIRECTION NEEDLE CARRIERS"},
    {"split", Op::split, true, 2, true, "split DIRECTION NEEDLE NEEDLE CARRIERS"},
    {"miss", Op::miss, true, 1, true, "miss DIRECTION NEEDLE CARRIERS"},
    {"drop", Op::drop, false, 1, false, "drop NEEDLE"},
    {"amiss", Op::amiss, false, 1, false, "amiss NEEDLE"},
    {"xfer", Op::xfer, false, 2, false, "xfer NEEDLE NEEDLE"},
    {"pause", Op::pause, false, 0, false, "pause"},
}};

constexpr std::array<std::string_view, 11> kKnownExtensions = {
    "x-stitch-number",      "x-speed-number",
    "x-xfer-stitch-number", "x-presser-mode",
    "x-sub-roller-number",  "x-roller-advance",
    "x-carrier-spacing",    "x-carrier-stopping-distance",
    "x-add-roller-advance", "x-end-pass",
    "x-xfer-style"};

std::string quoted(std::string_view word) { return "\"" + std::string(word) + "\""; }

Instruction extension(const Words& words) {
  Instruction i;
  i.op = Op::extension;
  for (const std::string_view word : words) {
    if (!i.text.empty()) i.text += ' ';
    i.text += word;
  }
  return i;
}

// Reads the words after the operation's name, one after another.
class Arguments {
 public:
  Arguments(const Words& words, const Form& form, std::optional<OperationComplaint>& complaint)
      : words_(words), form_(form), complaint_(complaint) {}

  bool direction(Side& side) {
    if (!more()) return missing();
    const std::string_view word = words_[next_++];
    if (word != "+" && word != "-") {
      return refuse("bad-direction", quoted(word) + " is no direction; it must be + or -");
    }
    side = word == "+" ? Side::right : Side::left;
    return true;
  }

  bool needle(Needle& needle) {
    if (!more()) return missing();
    const std::string_view word = words_[next_++];
    const std::optional<Needle> parsed = parse_needle(word);
    if (!parsed) return refuse("bad-needle", quoted(word) + " is no needle");
    needle = *parsed;
    return true;
  }

  bool carriers(const std::vector<std::string>* declared, std::vector<std::string>& set) {
    for (; more(); ++next_) {
      const std::string carrier(words_[next_]);
      if (declared &&
          std::find(declared->begin(), declared->end(), carrier) == declared->end()) {
        return refuse("carrier-not-declared",
                      "carrier " + quoted(carrier) + " is not in the Carriers header");
      }
      if (std::find(set.begin(), set.end(), carrier) != set.end()) {
        return refuse("carrier-twice", "carrier " + quoted(carrier) + " is named twice");
      }
      set.push_back(carrier);
    }
    return true;
  }

  bool end() {
    return !more() ||
           refuse("bad-arguments", quoted(words_[next_]) + " is too much; the form is \"" +
                                       std::string(form_.usage) + "\"");
  }

  bool missing() {
    return refuse("bad-arguments",
                  "something is missing; the form is \"" + std::string(form_.usage) + "\"");
  }

  bool refuse(std::string code, std::string message) {
    complaint_ = OperationComplaint{std::move(code), std::move(message), false};
    return false;
  }

 private:
  bool more() const { return next_ < words_.size(); }

  const Words& words_;
  const Form& form_;
  std::optional<OperationComplaint>& complaint_;
  std::size_t next_ = 1;
};

// Knitout's synonyms: making a loop of no yarn.
void name_by_meaning(Instruction& i) {
  if (!i.carriers.empty()) return;
  if (i.op == Op::knit) i.op = Op::drop;
  if (i.op == Op::tuck) i.op = Op::amiss;
  if (i.op == Op::split) i.op = Op::xfer;
  if (i.op == Op::drop || i.op == Op::amiss || i.op == Op::xfer) i.direction = Side::right;
}

bool parse_form(const Words& words, const Form& form, const std::vector<std::string>* declared,
                Instruction& i, std::optional<OperationComplaint>& complaint) {
  Arguments arguments(words, form, complaint);
  i.op = form.op;
  if (form.direction && !arguments.direction(i.direction)) return false;
  if (form.needles > 0 && !arguments.needle(i.needle)) return false;
  if (form.needles > 1 && !arguments.needle(i.target)) return false;
  if (form.carriers && !arguments.carriers(declared, i.carriers)) return false;
  if (!arguments.end()) return false;
  const bool needs_carrier = form.carriers && (form.needles == 0 || form.op == Op::miss);
  if (needs_carrier && i.carriers.empty()) {
    return arguments.refuse("no-carrier", std::string(form.name) + " needs a carrier");
  }
  name_by_meaning(i);
  return true;
}

}  // namespace

std::optional<Instruction> parse_operation(const std::vector<std::string_view>& words,
                                           const std::vector<std::string>* declared,
                                           std::optional<OperationComplaint>& complaint) {
  complaint.reset();
  if (words.empty()) return std::nullopt;
  const std::string_view name = words.front();
  if (name.substr(0, 2) == "x-") {
    const bool known = std::find(kKnownExtensions.begin(), kKnownExtensions.end(), name) !=
                       kKnownExtensions.end();
    if (!known) {
      complaint = OperationComplaint{"unknown-extension",
                                     quoted(name) + " is an extension that is not known", true};
    }
    return extension(words);
  }
  if (name == "stitch") {
    if (words.size() == 3 && parse_decimal(words[1]) && parse_decimal(words[2])) {
      return extension(words);
    }
    complaint = OperationComplaint{
        "bad-arguments", "stitch needs two numbers; the form is \"stitch LEADING SIZE\"",
        false};
    return std::nullopt;
  }
  Instruction i;
  if (name == "rack") {
    const std::optional<double> racking =
        words.size() == 2 ? parse_decimal(words[1]) : std::nullopt;
    if (!racking) {
      complaint = OperationComplaint{"bad-racking", "rack needs one number", false};
      return std::nullopt;
    }
    i.op = Op::rack;
    i.racking = *racking;
    return i;
  }
  const auto form =
      std::find_if(kForms.begin(), kForms.end(), [&](const Form& f) { return f.name == name; });
  if (form == kForms.end()) {
    complaint = OperationComplaint{"unknown-operation",
                                   quoted(name) + " is no knitout operation", false};
    return std::nullopt;
  }
  if (!parse_form(words, *form, declared, i, complaint)) return std::nullopt;
  return i;
}

}  // namespace meshknit
