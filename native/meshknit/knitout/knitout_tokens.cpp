#include "meshknit/knitout/knitout_tokens.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace meshknit {
namespace {

constexpr std::string_view kBlank = " \t";

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::optional<int> parse_whole(std::string_view digits, int largest) {
  if (!digits.empty() && digits.front() == '+') {
    digits.remove_prefix(1);
    if (digits.empty() || !is_digit(digits.front())) return std::nullopt;
  }
  int value = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  if (value > largest || value < -largest) return std::nullopt;
  return value;
}

}  // namespace

std::vector<std::string_view> split_words(std::string_view line) {
  std::vector<std::string_view> words;
  std::size_t begin = line.find_first_not_of(kBlank);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(kBlank, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBlank, end);
  }
  return words;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlank) - begin + 1);
}

std::optional<Needle> parse_needle(std::string_view word) {
  if (word.empty() || (word.front() != 'f' && word.front() != 'b')) return std::nullopt;
  Needle needle;
  needle.bed = word.front() == 'f' ? Bed::front : Bed::back;
  word.remove_prefix(1);
  if (!word.empty() && word.front() == 's') {
    needle.slider = true;
    word.remove_prefix(1);
  }
  if (word.empty() || word.front() == '+') return std::nullopt;
  const std::optional<int> index = parse_whole(word, kLargestNeedle);
  if (!index) return std::nullopt;
  needle.index = *index;
  return needle;
}

std::optional<int> parse_integer(std::string_view word) {
  return parse_whole(word, kLargestNeedle);
}

std::optional<double> parse_decimal(std::string_view word) {
  if (!word.empty() && word.front() == '+') {
    word.remove_prefix(1);
    if (!word.empty() && word.front() == '-') return std::nullopt;
  }
  // from_chars alone would also take "inf", "nan" and exponents.
  const bool plain = std::all_of(word.begin(), word.end(),
                                 [](char c) { return is_digit(c) || c == '.' || c == '-'; });
  if (!plain) return std::nullopt;
  double value = 0.0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  if (std::abs(value) > kLargestRacking) return std::nullopt;
  return value;
}

Source parse_source(std::string_view comment) {
  constexpr std::string_view tag = "!source:";
  if (comment.substr(0, tag.size()) != tag) return {};
  comment.remove_prefix(tag.size());
  const std::vector<std::string_view> words = split_words(comment);
  if (words.size() == 1 && words[0] == "waste") return {Source::Kind::waste, -1};
  if (words.size() == 1 && words[0] == "anchor") return {Source::Kind::anchor, -1};
  if (words.size() == 2 && words[0] == "stitch") {
    const std::optional<int> stitch = parse_whole(words[1], std::numeric_limits<int>::max());
    if (stitch && *stitch >= 0) return {Source::Kind::stitch, *stitch};
  }
  return {};
}

bool is_position(std::string_view value) {
  return value == "Left" || value == "Center" || value == "Right" || value == "Keep";
}

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
    const unsigned char lead = byte(i);
    const std::size_t length = lead < 0x80   ? 1
                               : lead < 0xC2 ? 0
                               : lead < 0xE0 ? 2
                               : lead < 0xF0 ? 3
                               : lead < 0xF5 ? 4
                                             : 0;
    if (length == 0 || i + length > text.size()) return false;
    for (std::size_t k = 1; k < length; ++k) {
      if ((byte(i + k) & 0xC0) != 0x80) return false;
    }
    if (length > 2) {
      // Over-long forms, surrogates and code points past the last one.
      const unsigned char second = byte(i + 1);
      if ((lead == 0xE0 && second < 0xA0) || (lead == 0xED && second >= 0xA0) ||
          (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second >= 0x90)) {
        return false;
      }
    }
    i += length;
  }
  return true;
}

}  // namespace meshknit
