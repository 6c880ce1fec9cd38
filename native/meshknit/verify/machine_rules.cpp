#include "meshknit/verify/machine_rules.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meshknit/knitout/knitout_tokens.h"
#include "meshknit/verify/fabric.h"

namespace meshknit {
namespace {

const std::string* header(const Program& program, const std::string& name) {
  const auto found = std::find_if(program.headers.begin(), program.headers.end(),
                                  [&](const auto& entry) { return entry.first == name; });
  return found == program.headers.end() ? nullptr : &found->second;
}

// Sizes above 9 may be written as one hexadecimal digit.
std::optional<double> setting_value(std::string_view word) {
  if (word.size() == 1 && word[0] >= 'A' && word[0] <= 'F') return 10.0 + (word[0] - 'A');
  return parse_decimal(word);
}

}  // namespace

void check_headers(const Program& program, const MachineProfile& profile, ProblemLog& log) {
  if (program.carriers != profile.carriers) {
    log.error("wrong-carriers", 0,
              "The file's Carriers header does not list the carriers of " + profile.name, {},
              "List exactly the machine's carriers, front to back.");
  }
  const std::string* machine = header(program, "Machine");
  if (machine && *machine != profile.machine_header) {
    log.error("wrong-machine", 0,
              "The file is for the machine \"" + *machine + "\", not for " + profile.name, {},
              "Choose the machine that the file was made for.");
  }
  const std::string* gauge = header(program, "Gauge");
  if (gauge && *gauge != std::to_string(profile.gauge)) {
    log.warning("other-gauge", 0, "The file names another gauge than the machine has", {},
                "Write the machine's needles an inch into the Gauge header, or leave it out.");
  }
}

int check_racking(const Instruction& i, const MachineProfile& profile, ProblemLog& log) {
  const double fraction = i.racking - std::floor(i.racking);
  if (fraction != 0.0 && fraction != profile.quarter_pitch) {
    log.error("racking-fraction", i.line,
              "the beds can stand on a needle or a quarter pitch beside it, nowhere else");
  }
  if (!(std::abs(i.racking) <= profile.max_racking)) {
    log.error("racking-too-far", i.line,
              "the racking goes beyond " + std::to_string(profile.max_racking) + " needles");
  } else if (std::abs(i.racking) > profile.liked_racking) {
    log.warning("racking-wide", i.line,
                "the racking goes beyond " + std::to_string(profile.liked_racking) +
                    " needles, which may break yarn",
                {}, "Use a yarn that stretches, and watch this place.");
  }
  return static_cast<int>(std::lround(i.racking * kQuarters));
}

void check_setting(const Instruction& i, const MachineProfile& profile, ProblemLog& log) {
  const std::vector<std::string_view> words = split_words(i.text);
  const auto setting = std::find_if(profile.settings.begin(), profile.settings.end(),
                                    [&](const MachineSetting& known) {
                                      return !words.empty() && known.name == words.front();
                                    });
  if (setting == profile.settings.end()) {
    log.warning("setting-unknown", i.line,
                "the machine does not know \"" + i.text + "\" and leaves it aside", {},
                "Remove the line, or use what this machine calls it.");
    return;
  }
  if (setting->highest < setting->lowest) return;
  const std::optional<double> value =
      words.size() == 2 ? setting_value(words[1]) : std::nullopt;
  if (!value || *value < setting->lowest || *value > setting->highest) {
    log.error("setting-out-of-range", i.line,
              "\"" + i.text + "\" needs a value from " + std::to_string(setting->lowest) +
                  " to " + std::to_string(setting->highest),
              {}, "Choose a value that the machine has.");
  }
}

bool check_needle(const Needle& needle, int line, const BedRange& beds,
                  const MachineProfile& profile, ProblemLog& log) {
  if (needle.slider && !profile.has_sliders) {
    log.error("no-sliders", line, "the machine has no sliders: " + to_string(needle));
  }
  if (beds.has(needle)) return true;
  log.error("needle-outside", line,
            to_string(needle) + " lies outside the bed, which has needles " +
                std::to_string(beds.lowest()) + " to " + std::to_string(beds.highest()),
            {}, "Make the object smaller or place it elsewhere on the bed.");
  return false;
}

void check_handover(const Instruction& i, int racking, ProblemLog& log) {
  if (i.needle.bed == i.target.bed) {
    log.error("transfer-same-bed", i.line,
              "loops pass between the beds only, not from " + to_string(i.needle) + " to " +
                  to_string(i.target));
    return;
  }
  if (i.needle.slider && i.target.slider) {
    log.error("slider-to-slider", i.line, "a slider cannot hand loops to a slider");
  }
  if (racking % kQuarters != 0) {
    log.error("transfer-at-quarter-pitch", i.line,
              "no needles face each other while the beds stand a fraction of a needle apart");
  } else if (kQuarters * racking_between(i.needle, i.target) != racking) {
    log.error("not-aligned", i.line,
              to_string(i.needle) + " and " + to_string(i.target) +
                  " face each other at racking " +
                  std::to_string(racking_between(i.needle, i.target)) + ", not at " +
                  std::to_string(racking / kQuarters));
  }
}

}  // namespace meshknit
