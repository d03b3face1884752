#include "appliance/programs/shows/settings_line.h"

namespace kaori::shows {
namespace {

// Whether a line gives `key` a value: its name, blanks, "=".
bool Sets(std::string_view line, std::string_view key) {
  constexpr std::string_view kBlank = " \t";
  const auto first = line.find_first_not_of(kBlank);
  if (first == std::string_view::npos || !line.substr(first).starts_with(key)) return false;
  const auto next = line.find_first_not_of(kBlank, first + key.size());
  return next != std::string_view::npos && line[next] == '=';
}

// Both [section] and [[list]] begin so: what follows belongs to them until the end of the text.
bool IsSection(std::string_view line) {
  const auto first = line.find_first_not_of(" \t");
  return first != std::string_view::npos && line[first] == '[';
}

// The lines of a text that set a key, and all others, each with a line end. Texts of several lines, which TOML has too, are no
// settings of a box: the check of the whole refuses them.
struct Parted {
  std::string of_key, others;
};

Parted Part(std::string_view text, std::string_view key) {
  Parted parted;
  // Only lines before the first section can be those of the key, which is one of the file's top.
  bool at_top = true;
  while (!text.empty()) {
    const auto end = text.find('\n');
    const auto line = text.substr(0, end);
    at_top = at_top && !IsSection(line);
    std::string& into = at_top && Sets(line, key) ? parted.of_key : parted.others;
    into += std::string(line) + "\n";
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return parted;
}

}  // namespace

// The lines of the key come from `own`, all others from `text`; the key's lines stand in front.
std::string WithLineOf(std::string_view text, std::string_view own, std::string_view key) {
  return Part(own, key).of_key + Part(text, key).others;
}

// In front, since behind the first [section] it would be a setting of that.
std::string WithSetting(std::string_view text, std::string_view key, std::string_view value) {
  const std::string line =
      value.empty() ? std::string() : std::string(key) + " = \"" + std::string(value) + "\"\n";
  return line + Part(text, key).others;
}

}  // namespace kaori::shows
