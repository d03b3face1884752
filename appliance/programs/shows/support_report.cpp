#include "appliance/programs/shows/support_report.h"

#include <sys/utsname.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "appliance/core/store/play_log.h"
#include "appliance/core/store/refused_usb.h"
#include "appliance/programs/shows/choice_files.h"
#include "appliance/programs/shows/settings_text.h"
#include "appliance/programs/status/lines.h"
#include "drivers/base/folder.h"
#include "drivers/base/read_file.h"
#include "drivers/base/run_program.h"
#include "drivers/base/utf8.h"

namespace kaori::shows {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostJournal_bytes = std::size_t{4} << 20U,
                      kMostWarnings_bytes = std::size_t{256} << 10U,
                      kMostPower_bytes = std::size_t{32} << 10U, kMostSmall_bytes = std::size_t{32} << 10U;
static_assert(kMostJournal_bytes + 2 * kMostWarnings_bytes + 10 * kMostSmall_bytes < kMostSupport_bytes);
constexpr std::size_t kLongestDeviceName = 60;
constexpr std::size_t kNumberDigits = 8;
constexpr Duration kLongestReading = std::chrono::minutes(1);

// The journal quotes what devices call themselves: of control characters the line's end alone is kept.
std::string Clean(std::string text) {
  for (char& c : text) {
    const auto code = static_cast<unsigned char>(c);
    if ((code < 0x20U && c != '\n' && c != '\t') || code == 0x7FU) c = '?';
  }
  return text;
}

// Of a text that is longer than it may be the beginning, in whole lines.
std::string Section(std::string_view title, std::string body, std::size_t most_bytes = kMostSmall_bytes) {
  if (body.empty()) body = "nothing\n";
  if (body.size() > most_bytes) {
    body.resize(body.rfind('\n', most_bytes - 1) + 1);
    body += "the rest is left out\n";
  }
  if (body.back() != '\n') body += '\n';
  return fmt::format("\n== {} ==\n\n{}", title, Clean(std::move(body)));
}

std::string TextOf(const fs::path& file) {
  const auto text = ReadBeginning(file, kMostSmall_bytes);
  return text ? *text : text.error().message() + "\n";
}

// The first line; empty where there is none.
std::string LineOf(const fs::path& file) {
  const std::string text = ReadBeginning(file, kMostSmall_bytes).value_or("");
  return text.substr(0, text.find('\n'));
}

// The lines of a text in which one of the words stands.
std::string LinesWith(std::string_view text, std::initializer_list<std::string_view> words) {
  std::string found;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);)
    if (std::ranges::any_of(words,
                            [&](std::string_view word) { return line.find(word) != std::string::npos; }))
      found += line + "\n";
  return found;
}

std::string JournalOf(const Journal& read, JournalPart part, std::size_t most_bytes) {
  const auto text = read(part, most_bytes);
  return text ? *text : "the journal cannot be read: " + text.error().message() + "\n";
}

// No SBOM lies in an image: its hash tells which build it is of.
std::string Versions(const SupportPlaces& places) {
  utsname kernel{};
  ::uname(&kernel);
  const status::Facts facts = status::ReadFacts(places.status);
  return fmt::format("kaori {}\nkernel {} {}\nroot hash of the image: {}\nSBOM: the image carries none\n{}",
                     KAORI_VERSION, kernel.release, kernel.machine,
                     facts.root_hash.empty() ? "none, it is not verified" : facts.root_hash,
                     TextOf(places.release));
}

// Ids, as the journal has them too; a show's name stands in the journal when it is read.
std::string Shows(const Folder& shows, const fs::path& plays) {
  const store::Choice choice = ReadChoice(shows);
  std::string text = fmt::format("chosen {} (choice {}), before it {}\n", choice.current, choice.generation,
                                 choice.previous);
  for (const std::string& name : shows.Names().value_or(std::vector<std::string>{}))
    text += fmt::format("{} {} bytes\n", name, shows.BytesOf(name));
  return text + "what became of them since the box was switched on:\n" +
         ReadBeginning(plays, kMostSmall_bytes).value_or("nothing is known\n");
}

std::string Space(const Folder& shows) {
  const auto free = shows.FreeBytes();
  if (!free) return free.error().message();
  return fmt::format("{:.1f} MB are free on the data partition\n", static_cast<double>(*free) * 1e-6);
}

// Hubs and devices, whether or not they are authorised; no serial numbers. Below one that kaori-usb refused
// stands why.
std::string UsbDevices(const SupportPlaces& places) {
  const auto devices = ListFolder(places.usb);
  if (!devices) return devices.error().message();
  std::string text;
  for (const fs::path& device : *devices) {
    if (!IsThere(device / "idVendor")) continue;
    text += fmt::format("{:12} {}:{} {} {} {}\n", device.filename().string(), LineOf(device / "idVendor"),
                        LineOf(device / "idProduct"),
                        LineOf(device / "authorized") == "0" ? "unauthorised" : "authorised  ",
                        utf8::Printable(LineOf(device / "manufacturer"), kLongestDeviceName),
                        utf8::Printable(LineOf(device / "product"), kLongestDeviceName));
    const auto refused = store::ParseRefusedUsb(TextOf(places.status.usb / device.filename()));
    if (refused) text += "             " + refused->english + "\n";
  }
  return text;
}

std::string Status(const SupportPlaces& places, const board::Board* board) {
  if (board == nullptr) return "the box's programs do not run\n";
  const auto facts = status::ReadFacts(places.status);
  return status::TextOf(status::Describe(status::Look(*board, facts, SteadyClock().now())));
}

// Names begin with the log's number and its day: the last one is of the newest evening. A link is none of our reports: a disk
// that was elsewhere could have one to a file that is nobody's but the box's.
std::string NewestShowReport(const fs::path& reports) {
  fs::path newest;
  std::error_code none;
  for (const fs::path& file : ListFolder(reports).value_or(std::vector<fs::path>{}))
    if (file.filename().string().ends_with(".report.txt") && !fs::is_symlink(file, none)) newest = file;
  return newest.empty() ? "there is none yet\n" : newest.filename().string() + "\n\n" + TextOf(newest);
}

std::string Date(std::time_t wall) {
  std::tm local{};
  ::localtime_r(&wall, &local);
  std::array<char, 64> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S %z", &local);
  return {text.data(), length};
}

}  // namespace

// In one line each, with date and time. Of this system's journal all that it finds: on a box whose number was
// lost, also what was written under the number before.
Result<std::string> ReadJournal(const JournalSource& source, JournalPart part, std::size_t most_bytes) {
  std::vector<std::string> words{source.program, "--quiet", "--no-pager", "--no-hostname",
                                 "--output=short-iso"};
  words.push_back(source.folder.empty() ? "--merge" : "--directory=" + source.folder);
  if (part == JournalPart::kWarnings) words.emplace_back("--priority=warning");
  if (part == JournalPart::kPower) words.emplace_back("--unit=kaori-power.service");
  return OutputOf(words, most_bytes, kLongestReading);
}

std::string NameForFiles(std::string host, const std::string& number) {
  if (!host.ends_with(number)) host += "-" + number;
  for (char& c : host)
    if (!((c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'))) c = '-';
  return host;
}

std::string BoxName(const SupportPlaces& places) {
  utsname host{};
  ::uname(&host);
  return NameForFiles(host.nodename, LineOf(places.machine_id).substr(0, kNumberDigits));
}

// What a technician asks first stands first; the journal, which is long, last.
std::string SupportReport(const SupportPlaces& places, const Folder& shows, const board::Board* board,
                          const Journal& journal, std::time_t wall) {
  const std::string power = JournalOf(journal, JournalPart::kPower, kMostPower_bytes);
  const std::string warnings = JournalOf(journal, JournalPart::kWarnings, kMostWarnings_bytes);
  return fmt::format(
             "Support file of the box {}, made {} by its clock. docs/support.md says how it is read.\n",
             BoxName(places), Date(wall)) +
         Section(
             "Why the last starts ended",
             LinesWith(power, {"the last start ended", "nothing is known of a start", "cannot be read"})) +
         Section("Status", Status(places, board)) + Section("Versions", Versions(places)) +
         Section("Shows", Shows(shows, places.plays)) + Section("Free space", Space(shows)) +
         Section("Show report of the last evening", NewestShowReport(places.reports)) +
         Section("Settings (box.toml), without secrets", SettingsText(places.settings)) +
         Section("Screens", TextOf(places.status.screens)) + Section("USB devices", UsbDevices(places)) +
         Section("Crash reports", LinesWith(warnings, {"crash:"}), kMostWarnings_bytes) +
         Section("Warnings and worse", warnings, kMostWarnings_bytes) +
         Section("Journal", JournalOf(journal, JournalPart::kAll, kMostJournal_bytes), kMostJournal_bytes);
}

}  // namespace kaori::shows
