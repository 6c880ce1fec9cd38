#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "meshknit/machine/needle.h"
#include "meshknit/machine/program.h"

namespace meshknit {

/// Largest needle number (either sign) and racking that a file may name; far beyond any
/// machine, small enough that sums of them stay exact.
constexpr int kLargestNeedle = 1000000;
constexpr double kLargestRacking = 10000.0;

/// Words of a line: what stands between spaces and tabs.
std::vector<std::string_view> split_words(std::string_view line);

/// Without spaces and tabs at both ends.
std::string_view trimmed(std::string_view text);

/// f12, b-3, fs4, bs4; nothing for any other text.
std::optional<Needle> parse_needle(std::string_view word);

/// A whole number within +-kLargestNeedle, "+" allowed in front.
std::optional<int> parse_integer(std::string_view word);

/// A decimal number within +-kLargestRacking, "+" allowed in front, no exponent.
std::optional<double> parse_decimal(std::string_view word);

/// What a comment (without its ';') says of where the line comes from: "!source: stitch 12",
/// "!source: waste", "!source: anchor". Any other comment names nothing.
Source parse_source(std::string_view comment);

/// A value of the Position header: Left, Center, Right or Keep.
bool is_position(std::string_view value);

/// True if the bytes are well-formed UTF-8.
bool is_utf8(std::string_view text);

}  // namespace meshknit
