#include "meshknit/knitout/kcode_settings.h"

#include <cctype>
#include <optional>
#include <string_view>
#include <vector>

#include "meshknit/core/error.h"
#include "meshknit/knitout/knitout_tokens.h"

namespace meshknit {
namespace {

[[noreturn]] void refuse(const std::string& text) {
  throw InvalidInput("a .kc file cannot hold the setting \"" + text + "\"");
}

char size_of(const std::string& text, std::string_view value) {
  if (value.size() != 1 || std::isalnum(static_cast<unsigned char>(value[0])) == 0)
    refuse(text);
  return value[0];
}

int number_of(const std::string& text, std::string_view value) {
  const std::optional<int> number = parse_integer(value);
  if (!number) refuse(text);
  return *number;
}

}  // namespace

void KcodeSettings::take(const std::string& text) {
  const std::vector<std::string_view> words = split_words(text);
  if (words.empty()) refuse(text);
  const std::string_view name = words.front();
  const std::string_view value = words.size() == 2 ? words[1] : std::string_view();
  if (name == "x-stitch-number") stitch = size_of(text, value);
  if (name == "x-xfer-stitch-number") transfer = size_of(text, value);
  if (name == "x-speed-number") speed = number_of(text, value);
  if (name == "x-roller-advance") roller = number_of(text, value);
  if (name == "x-add-roller-advance") added_roller = number_of(text, value);
}

}  // namespace meshknit
