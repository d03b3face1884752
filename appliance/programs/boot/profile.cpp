#include "appliance/programs/boot/profile.h"

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

bool IsQuoted(std::string_view value) {
  return value.size() >= 2 && value.front() == '"' && value.back() == '"';
}

std::string TakeName(std::string_view value, std::string& name) {
  if (!IsQuoted(value)) return "expected a value in quotes";
  const auto wanted = value.substr(1, value.size() - 2);
  if (std::ranges::find(kNames, wanted) == kNames.end())
    return "there is no profile " + std::string(value) + ": stage, kiosk or bench";
  name = wanted;
  return {};
}

bool IsOfScreenName(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || letter == '-' ||
         (letter >= '0' && letter <= '9');
}

// Sockets of a card have short names; what has none of that kind is a slip of somebody's hand.
std::string TakeScreen(std::string_view value, std::string& screen) {
  constexpr std::size_t kLongestName = 32, kLongestNumber = 2;
  const auto wanted = IsQuoted(value) ? value.substr(1, value.size() - 2) : value;
  const bool is_number = !wanted.empty() && wanted.size() <= kLongestNumber && wanted.front() != '0' &&
                         std::ranges::all_of(wanted, [](char c) { return c >= '0' && c <= '9'; });
  const bool is_name =
      IsQuoted(value) && wanted.size() <= kLongestName && std::ranges::all_of(wanted, IsOfScreenName);
  if (!is_number && !is_name) return "expected a screen's name, as in \"HDMI-A-2\", or its number";
  screen = wanted;
  return {};
}

// Reads line by line; the first fault is the last thing it reads.
class Reading {
 public:
  void Parse(std::string_view line) {
    ++number_;
    if (line.starts_with('[')) section_ = line;
    const bool ours = section_.empty() || section_ == kLines;
    if (line.empty() || line.starts_with('[') || !ours) return;
    if (const auto wrong = TakeSetting(line); !wrong.empty()) Blame(wrong);
    if (!section_.empty()) wired_at_ = number_;
  }
  bool ended() const { return !profile_.fault.empty(); }
  Profile End() {
    const auto wrong = CheckWiring(profile_.wiring);
    if (!ended() && !wrong.empty()) {
      number_ = wired_at_;
      Blame(wrong);
    }
    return profile_;
  }

 private:
  static constexpr std::string_view kLines = "[lines]";

  std::string TakeSetting(std::string_view line) {
    const auto equals = line.find('=');
    if (equals == std::string_view::npos) return "expected a name, = and a value";
    const auto key = Trim(line.substr(0, equals));
    const auto value = Trim(line.substr(equals + 1));
    if (!section_.empty()) return ParseWire(key, value, profile_.wiring);
    if (key == "profile") return TakeName(value, profile_.name);
    if (key == "status_screen") return TakeScreen(value, profile_.status_screen);
    return "there is no setting " + std::string(key);
  }
  // Half a file is not believed.
  void Blame(const std::string& wrong) {
    profile_ = {.fault = "line " + std::to_string(number_) + ": " + wrong};
  }

  Profile profile_;
  std::string_view section_;
  int number_ = 0;
  int wired_at_ = 0;
};

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
  Reading reading;
  while (!text.empty() && !reading.ended()) {
    const auto end = text.find('\n');
    reading.Parse(Trim(WithoutComment(text.substr(0, end))));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return reading.End();
}

Profile ChooseProfile(const fs::path& folder) {
  const fs::path file = folder / "box.toml";
  const fs::path last_good = folder / "box.last-good.toml";
  const auto text = TextOf(file);
  if (!text) return {};
  const Profile chosen = ReadProfile(*text);
  const auto before = TextOf(last_good);
  if (chosen.fault.empty()) {
    if (before != text) Keep(last_good, *text);
    return chosen;
  }
  Profile sound = before ? ReadProfile(*before) : Profile();
  sound.fault = "box.toml, " + chosen.fault + "; the profile is " + sound.name;
  return sound;
}

}  // namespace kaori::boot
