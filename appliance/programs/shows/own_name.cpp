#include "appliance/programs/shows/own_name.h"

namespace kaori::shows {
namespace {

// Whether a line gives the box its name: "name", blanks, "=".
bool IsName(std::string_view line) {
  constexpr std::string_view kBlank = " \t";
  const auto first = line.find_first_not_of(kBlank);
  if (first == std::string_view::npos || !line.substr(first).starts_with("name")) return false;
  const auto next = line.find_first_not_of(kBlank, first + 4);
  return next != std::string_view::npos && line[next] == '=';
}

bool IsSection(std::string_view line) {
  const auto first = line.find_first_not_of(" \t");
  return first != std::string_view::npos && line[first] == '[';
}

// The lines that give a name are `taken`, all others are `left`.
struct Parted {
  std::string taken, left;
};

Parted Part(std::string_view text) {
  Parted parted;
  bool at_top = true;
  while (!text.empty()) {
    const auto end = text.find('\n');
    const auto line = text.substr(0, end);
    at_top = at_top && !IsSection(line);
    std::string& into = at_top && IsName(line) ? parted.taken : parted.left;
    into += std::string(line) + "\n";
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return parted;
}

}  // namespace

std::string WithNameOf(std::string_view text, std::string_view own) {
  return Part(own).taken + Part(text).left;
}

}  // namespace kaori::shows
