#include "firmware/boot/profile.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>

namespace kaori::boot {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kNames{"stage", "kiosk", "bench"};
constexpr std::string_view kBlank = " \t\r";
constexpr std::size_t kLongest_bytes = 1 << 16;

std::string_view Trim(std::string_view words) {
  const auto first = words.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return words.substr(first, words.find_last_not_of(kBlank) - first + 1);
}

std::string_view WithoutComment(std::string_view line) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] == '#' && !quoted) return line.substr(0, i);
  }
  return line;
}

// Takes what a line says into `name`; or says what is wrong with it.
std::string Take(std::string_view line, std::string& name) {
  const auto equals = line.find('=');
  if (equals == std::string_view::npos) return "expected a name, = and a value";
  const auto key = Trim(line.substr(0, equals));
  if (key != "profile") return "there is no setting " + std::string(key);
  const auto value = Trim(line.substr(equals + 1));
  if (value.size() < 2 || value.front() != '"' || value.back() != '"') return "expected a value in quotes";
  const auto wanted = value.substr(1, value.size() - 2);
  if (std::ranges::find(kNames, wanted) == kNames.end())
    return "there is no profile " + std::string(value) + ": stage, kiosk or bench";
  name = wanted;
  return {};
}

std::optional<std::string> TextOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::string text(kLongest_bytes, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

bool WriteWhole(int fd, std::string_view text) {
  const ssize_t written = ::write(fd, text.data(), text.size());
  return written >= 0 && static_cast<std::size_t>(written) == text.size() && ::fsync(fd) == 0;
}

// A draft that was cut short by the power is never looked at.
void Keep(const fs::path& path, std::string_view text) {
  const std::string draft = path.string() + ".draft";
  const int fd = ::open(draft.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (fd < 0) return;
  const bool whole = WriteWhole(fd, text);
  ::close(fd);
  if (whole) std::rename(draft.c_str(), path.c_str());
}

}  // namespace

Profile ReadProfile(std::string_view text) {
  Profile profile;
  for (int number = 1; !text.empty(); ++number) {
    const auto end = text.find('\n');
    const auto line = Trim(WithoutComment(text.substr(0, end)));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.starts_with('[')) break;
    if (line.empty()) continue;
    if (const auto wrong = Take(line, profile.name); !wrong.empty())
      return {.name = Profile().name, .fault = "line " + std::to_string(number) + ": " + wrong};
  }
  return profile;
}

Profile ChooseProfile(const fs::path& folder) {
  const fs::path file = folder / "box.toml";
  const fs::path last_good = folder / "box.last-good.toml";
  const auto text = TextOf(file);
  if (!text) return {};
  Profile chosen = ReadProfile(*text);
  const auto before = TextOf(last_good);
  if (chosen.fault.empty()) {
    if (before != text) Keep(last_good, *text);
    return chosen;
  }
  if (before) chosen.name = ReadProfile(*before).name;
  chosen.fault = "box.toml, " + chosen.fault + "; the profile is " + chosen.name;
  return chosen;
}

}  // namespace kaori::boot
