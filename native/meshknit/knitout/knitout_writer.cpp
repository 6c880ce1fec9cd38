#include "meshknit/knitout/knitout_writer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "meshknit/core/error.h"
#include "meshknit/knitout/knitout_operations.h"
#include "meshknit/knitout/knitout_tokens.h"

namespace meshknit {
namespace {

std::string decimal(double value) {
  // No exponents: not every reader knows them. 400 characters hold every double written out.
  std::array<char, 400> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value + 0.0,
                                 std::chars_format::fixed);
  return std::string(text.data(), end.ptr);
}

class Writer {
 public:
  explicit Writer(const Program& program) : program_(program) {}

  std::string write() {
    text_ = ";!knitout-2\n";
    write_headers();
    for (const Instruction& i : program_.instructions) {
      write_instruction(i);
      ++number_;
    }
    if (!is_utf8(text_)) throw InvalidInput("a header or extension is not UTF-8 text");
    return std::move(text_);
  }

 private:
  void write_headers() {
    if (program_.carriers.empty()) throw InvalidInput("a program needs carriers");
    text_ += ";;Carriers: ";
    for (std::size_t c = 0; c < program_.carriers.size(); ++c) {
      const std::string& carrier = program_.carriers[c];
      const auto earlier = program_.carriers.begin() + static_cast<std::ptrdiff_t>(c);
      if (carrier.empty() || carrier.find_first_of(" \t,;\r\n") != std::string::npos ||
          std::find(program_.carriers.begin(), earlier, carrier) != earlier) {
        throw InvalidInput("\"" + carrier + "\" cannot be the name of a carrier");
      }
      if (c > 0) text_ += ' ';
      text_ += carrier;
    }
    text_ += '\n';
    for (std::size_t h = 0; h < program_.headers.size(); ++h) {
      const auto& [name, value] = program_.headers[h];
      const auto earlier = program_.headers.begin() + static_cast<std::ptrdiff_t>(h);
      const bool twice = std::any_of(program_.headers.begin(), earlier,
                                     [&](const auto& other) { return other.first == name; });
      if (name.empty() || value.empty() || name == "Carriers" || twice ||
          (name == "Position" && !is_position(value)) ||
          name.find_first_of(":\t\r\n") != std::string::npos ||
          value.find_first_of("\t\r\n") != std::string::npos || trimmed(value) != value) {
        throw InvalidInput("\"" + name + ": " + value + "\" cannot be a knitout header");
      }
      text_ += ";;" + name + ": " + value + "\n";
    }
  }

  void write_instruction(const Instruction& i) {
    if (i.op == Op::rack) {
      if (!(std::abs(i.racking) <= kLargestRacking)) refuse("its racking is out of range");
      if (i.racking == racking_) return;
      racking_ = i.racking;
    }
    write_operation(i);
    write_source(i.source);
    text_ += '\n';
  }

  void write_operation(const Instruction& i) {
    switch (i.op) {
      case Op::in:
        return write_set("in", i);
      case Op::out:
        return write_set("out", i);
      case Op::inhook:
        return write_set("inhook", i);
      case Op::releasehook:
        return write_set("releasehook", i);
      case Op::outhook:
        return write_set("outhook", i);
      case Op::rack:
        text_ += "rack " + decimal(i.racking);
        return;
      case Op::knit:
        return i.carriers.empty() ? write_bare("drop", i, false) : write_loop("knit", i, false);
      case Op::tuck:
        return i.carriers.empty() ? write_bare("amiss", i, false)
                                  : write_loop("tuck", i, false);
      case Op::split:
        return i.carriers.empty() ? write_bare("xfer", i, true) : write_loop("split", i, true);
      case Op::miss:
        if (i.carriers.empty()) refuse("a miss needs a carrier");
        return write_loop("miss", i, false);
      case Op::drop:
        return write_bare("drop", i, false);
      case Op::amiss:
        return write_bare("amiss", i, false);
      case Op::xfer:
        return write_bare("xfer", i, true);
      case Op::pause:
        text_ += "pause";
        return;
      case Op::extension:
        return write_extension(i.text);
    }
  }

  void write_set(std::string_view name, const Instruction& i) {
    if (i.carriers.empty()) refuse("it names no carrier");
    text_ += name;
    write_carriers(i);
  }

  void write_loop(std::string_view name, const Instruction& i, bool target) {
    text_ += name;
    text_ += i.direction == Side::right ? " +" : " -";
    write_needle(i.needle);
    if (target) write_needle(i.target);
    write_carriers(i);
  }

  void write_bare(std::string_view name, const Instruction& i, bool target) {
    if (!i.carriers.empty()) refuse("it takes no carrier");
    text_ += name;
    write_needle(i.needle);
    if (target) write_needle(i.target);
  }

  void write_needle(const Needle& needle) {
    if (needle.index < 1 || needle.index > kLargestNeedle) {
      refuse("needle " + to_string(needle) + " is out of range");
    }
    text_ += ' ' + to_string(needle);
  }

  void write_carriers(const Instruction& i) {
    for (std::size_t c = 0; c < i.carriers.size(); ++c) {
      const std::string& carrier = i.carriers[c];
      const auto earlier = i.carriers.begin() + static_cast<std::ptrdiff_t>(c);
      if (std::find(program_.carriers.begin(), program_.carriers.end(), carrier) ==
              program_.carriers.end() ||
          std::find(i.carriers.begin(), earlier, carrier) != earlier) {
        refuse("carrier \"" + carrier + "\" is unknown or named twice");
      }
      text_ += ' ' + carrier;
    }
  }

  // The text must come back as it is: one operation, no comment, one space between words.
  void write_extension(const std::string& text) {
    std::optional<OperationComplaint> complaint;
    std::optional<Instruction> back;
    if (text.find_first_of(";\r\n") == std::string::npos) {
      back = parse_operation(split_words(text), nullptr, complaint);
    }
    if (!back || back->op != Op::extension || back->text != text) {
      refuse("\"" + text + "\" is no extension");
    }
    text_ += text;
  }

  void write_source(const Source& source) {
    switch (source.kind) {
      case Source::Kind::none:
        return;
      case Source::Kind::stitch:
        if (source.stitch < 0) refuse("its source is no stitch");
        text_ += " ;!source: stitch " + std::to_string(source.stitch);
        return;
      case Source::Kind::waste:
        text_ += " ;!source: waste";
        return;
      case Source::Kind::anchor:
        text_ += " ;!source: anchor";
        return;
    }
  }

  [[noreturn]] void refuse(const std::string& why) const {
    throw InvalidInput("instruction " + std::to_string(number_) + " cannot be written: " + why);
  }

  const Program& program_;
  std::string text_;
  double racking_ = 0.0;
  std::size_t number_ = 0;
};

}  // namespace

std::string write_knitout(const Program& program) { return Writer(program).write(); }

}  // namespace meshknit
