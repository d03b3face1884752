#include "appliance/programs/boot/profile.h"

#include <algorithm>
#include <array>
#include <utility>

#include "drivers/base/number.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::boot {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBlank = " \t\r";
// Far more than a person writes; process 1 reads nothing without a bound.
constexpr std::size_t kMostProfile_bytes = 1 << 16;

// Without blanks at both ends; "\r" is one, for files from other systems.
std::string_view Trim(std::string_view words) {
  const auto first = words.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return words.substr(first, words.find_last_not_of(kBlank) - first + 1);
}

// A # within quotes is part of the text. Quotes cannot be escaped in the values that we take.
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

// Each Parse function gives what is wrong with the value, in words that follow on "line N: ", or nothing.
std::string ParseProfileName(std::string_view value, std::string& name) {
  if (!IsQuoted(value)) return "expected a value in quotes";
  const auto wanted = value.substr(1, value.size() - 2);
  if (std::ranges::find(kProfileNames, wanted) == kProfileNames.end())
    return "there is no profile " + std::string(value) + ": stage, kiosk or bench";
  name = wanted;
  return {};
}

bool IsOfScreenName(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || letter == '-' ||
         (letter >= '0' && letter <= '9');
}

// It becomes the host's name, and a part of files' names (RFC 1123, 2.1, but that it is shorter).
std::string ParseBoxName(std::string_view value, std::string& name) {
  constexpr std::size_t kLongestBoxName = 32;
  const auto wanted = IsQuoted(value) ? value.substr(1, value.size() - 2) : std::string_view{};
  if (wanted.empty() || wanted.size() > kLongestBoxName || wanted.front() == '-' || wanted.back() == '-' ||
      !std::ranges::all_of(wanted, IsOfScreenName))
    return "expected a name for the box of at most 32 letters, digits and \"-\", as in \"left-lobby\"";
  name = wanted;
  return {};
}

// Sockets of a card have short names; what has none of that kind is a slip of somebody's hand. A number
// counts from 1 and has no leading zero.
std::string ParseScreen(std::string_view value, std::string& screen) {
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

// The text goes into an environment file of systemd and is cut at blanks there. kaori-input checks it again;
// the two programs share no code.
std::string ParseDialBox(std::string_view value, std::string& dial_box) {
  constexpr std::array<std::string_view, 3> kKinds{"=sgi", "=spectragraphics", "=dls80"};
  constexpr std::size_t kLongestLine = 200;
  const auto wanted = IsQuoted(value) ? value.substr(1, value.size() - 2) : std::string_view{};
  const auto fits = [](char c) {
    return IsOfScreenName(c) || (c != '\0' && std::string_view("/_.:=").find(c) != std::string_view::npos);
  };
  const bool is_line =
      wanted.starts_with("/dev/") && wanted.size() <= kLongestLine && std::ranges::all_of(wanted, fits);
  if (!is_line || std::ranges::none_of(kKinds, [&](auto kind) { return wanted.ends_with(kind); }))
    return "expected a serial line and its kind of box, as in \"/dev/ttyUSB0=sgi\": sgi, spectragraphics or "
           "dls80";
  dial_box = wanted;
  return {};
}

// Lines are judged by their number alone: which of them a chip has, and that none is named twice, kaori-input sees.
std::string ParseDialLines(std::string_view value, std::string& dial_lines) {
  constexpr std::ptrdiff_t kMostLines = 16;
  const auto wanted = IsQuoted(value) ? value.substr(1, value.size() - 2) : std::string_view{};
  const auto colon = std::min(wanted.find(':'), wanted.size());
  const auto chip = wanted.substr(0, colon), lines = wanted.substr(std::min(colon + 1, wanted.size()));
  const auto is_chip = [](char c) { return IsOfScreenName(c) || c == '_'; };
  const auto is_line = [](char c) { return (c >= '0' && c <= '9') || c == ','; };
  const auto commas = std::ranges::count(lines, ',');
  const bool is_list = !lines.empty() && std::ranges::all_of(lines, is_line) && lines.front() != ',' &&
                       lines.back() != ',' && lines.find(",,") == std::string_view::npos;
  if (chip.empty() || !std::ranges::all_of(chip, is_chip) || !is_list || commas % 2 == 0 ||
      commas >= kMostLines)
    return "expected a GPIO chip and two lines for each dial, as in \"gpiochip0:4,5,6,7\"";
  dial_lines = wanted;
  return {};
}

// Names of the tz database: "Asia/Tokyo", "Etc/GMT-9". It goes into an environment file of systemd, and is a
// path below a folder.
std::string ParseZone(std::string_view value, std::string& zone) {
  constexpr std::size_t kLongestZone = 64;
  const auto wanted = IsQuoted(value) ? value.substr(1, value.size() - 2) : std::string_view{};
  const auto fits = [](char c) { return IsOfScreenName(c) || c == '/' || c == '_' || c == '+'; };
  if (wanted.empty() || wanted.size() > kLongestZone || wanted.front() == '/' || wanted.back() == '/' ||
      !std::ranges::all_of(wanted, fits))
    return "expected the name of a time zone, as in \"Asia/Tokyo\"";
  zone = wanted;
  return {};
}

// Returns what is wrong, or nothing; `counts` changes only where the value is right.
std::string ParseDialBoxCounts(std::string_view value, int& counts) {
  constexpr int kMostCounts = 1 << 20;  // As kaori-input takes them.
  const auto number = ParseNumber<int>(value);
  if (!number || *number < 1 || *number > kMostCounts)
    return "expected how many counts a turn has, a whole number from 1 to " + std::to_string(kMostCounts);
  counts = *number;
  return {};
}

// Reads line by line; the first fault is the last thing it reads. Not a TOML parser: process 1 needs a
// handful of lines and must not fail in a library. What it takes is a part of TOML, and sections that are not
// its own may hold anything.
class Reading {
 public:
  // One line without its comment and its blanks.
  void Parse(std::string_view line) {
    ++number_;
    if (line.starts_with('[')) section_ = line;
    const bool ours = section_.empty() || section_ == kLines || section_ == kClock || section_ == kNetwork;
    if (line.empty() || line.starts_with('[') || !ours) return;
    if (const auto wrong = ParseSetting(line); !wrong.empty()) Blame(wrong);
    if (section_ == kLines) wired_at_ = number_;
  }
  bool ended() const { return !profile_.fault.empty(); }
  // The wiring is judged as a whole, at the line of [lines] that was read last.
  Profile End() {
    const auto wrong = CheckWiring(profile_.wiring);
    if (!ended() && !wrong.empty()) {
      number_ = wired_at_;
      Blame(wrong);
    }
    return profile_;
  }

 private:
  static constexpr std::string_view kLines = "[lines]", kClock = "[clock]", kNetwork = "[network]";

  // A setting of the top, of [clock], of [network], or a wire of [lines]; gives what is wrong with it.
  std::string ParseSetting(std::string_view line) {
    const auto equals = line.find('=');
    if (equals == std::string_view::npos) return "expected a name, = and a value";
    const auto key = Trim(line.substr(0, equals));
    const auto value = Trim(line.substr(equals + 1));
    if (section_ == kLines) return ParseWire(key, value, profile_.wiring);
    if (section_ == kClock)
      return key == "zone" ? ParseZone(value, profile_.zone)
                           : "there is no setting " + std::string(key) + " of [clock]";
    if (section_ == kNetwork) return ParseNetwork(key, value, profile_.network);
    if (key == "profile") return ParseProfileName(value, profile_.name);
    if (key == "name") return ParseBoxName(value, profile_.box_name);
    if (key == "status_screen") return ParseScreen(value, profile_.status_screen);
    if (key == "monitor_screen") return ParseScreen(value, profile_.monitor_screen);
    if (key == "dial_box") return ParseDialBox(value, profile_.dial_box);
    if (key == "dial_lines") return ParseDialLines(value, profile_.dial_lines);
    if (key == "dial_box_counts") return ParseDialBoxCounts(value, profile_.dial_box_counts);
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

}  // namespace

// The text is cut into lines here; the last one need not end.
Profile ReadProfile(std::string_view text) {
  Reading reading;
  while (!text.empty() && !reading.ended()) {
    const auto end = text.find('\n');
    reading.Parse(Trim(WithoutComment(text.substr(0, end))));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return reading.End();
}

// Options of kaori-input in one variable, which systemd splits at blanks: no value here has one. A serial box and dials on GPIO
// lines may stand side by side; the one that comes second is then a spare, and the log names it.
std::string DialsEnvironmentOf(const Profile& profile) {
  if (profile.dial_box.empty() && profile.dial_lines.empty()) return "KAORI_DIALS=\n";
  std::string options;
  if (!profile.dial_box.empty()) options += " --serial " + profile.dial_box;
  if (!profile.dial_lines.empty()) options += " --dials " + profile.dial_lines;
  if (profile.dial_box_counts != 0)
    options += " --counts-per-turn " + std::to_string(profile.dial_box_counts);
  return "KAORI_DIALS=" + options.substr(1) + "\n";
}

std::string ClockEnvironmentOf(const Profile& profile) {
  return profile.zone.empty() ? std::string() : "TZ=" + profile.zone + "\n";
}

std::string DropUnknownZone(Profile& profile, const fs::path& zones) {
  std::error_code none;
  if (profile.zone.empty() || fs::is_regular_file(zones / profile.zone, none)) return {};
  return "box.toml: the box knows no time zone \"" + std::exchange(profile.zone, {}) + "\"; its clock is UTC";
}

// A file that cannot be read at all (its message names it) counts as faulty; one that is missing stands for
// the usual profile.
Profile ChooseProfile(const fs::path& folder) {
  const fs::path file = folder / "box.toml";
  const fs::path last_good = folder / "box.last-good.toml";
  const auto text = ReadFile(file, {.most_bytes = kMostProfile_bytes});
  if (!text && text.error().cause == std::errc::no_such_file_or_directory) return {};
  Profile chosen = text ? ReadProfile(*text) : Profile{.fault = text.error().message()};
  const auto before = ReadFile(last_good, {.most_bytes = kMostProfile_bytes});
  if (chosen.fault.empty()) {
    // A disk that is full or broken changes nothing now: the box only has no last good settings next time.
    if (!before || *before != *text) static_cast<void>(WriteWholeFile(last_good, {AsBytes(*text)}));
    return chosen;
  }
  Profile valid = before ? ReadProfile(*before) : Profile();
  valid.fault = (text ? "box.toml, " : "") + chosen.fault + "; the profile is " + valid.name;
  return valid;
}

}  // namespace kaori::boot
