#include "appliance/programs/lips/generations.h"

#include <system_error>

#include <fmt/format.h>

#include "drivers/base/checksum.h"
#include "drivers/base/log.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::lips {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxLipSettings_bytes = 65536;
// The checksum is the first line, so that a file that was cut short has one too, which does not fit. It is
// FNV-1a of all that follows: it finds damage and is no defence against people.
constexpr std::string_view kSum = "# checksum ";
constexpr std::string_view kAdvice = " of all lines below. Remove this line when you change them by hand.\n";

std::string ChecksumLine(std::string_view text) {
  return fmt::format("{}{:016x}{}", kSum, Fnv1a(text), kAdvice);
}

std::string WithChecksum(const LipSettings& settings) {
  const std::string text = LipSettingsText(settings);
  return ChecksumLine(text) + text;
}

// The whole first line must be the one that would be written for these lines.
bool ChecksumFits(std::string_view file) {
  if (!file.starts_with(kSum)) return true;
  const auto end = file.find('\n');
  return end != std::string_view::npos && file.substr(0, end + 1) == ChecksumLine(file.substr(end + 1));
}

// Where the settings that were saved before lie.
fs::path BeforeOf(const fs::path& file) {
  return file.string() + ".before";
}

// Returns nothing where there is no file. A file without any "=" is one that lost its content, as a power cut
// may leave it, and is not taken for defaults.
Result<std::optional<LipSettings>> ReadOne(const fs::path& file) {
  std::error_code none;
  if (!fs::exists(file, none)) return std::nullopt;
  const auto text = ReadFile(file, {.most_bytes = kMaxLipSettings_bytes});
  if (!text) return tl::unexpected(text.error());
  if (text->find('=') == std::string::npos) return FailInput(file.string() + ": the file holds no settings");
  if (!ChecksumFits(*text)) return FailInput(file.string() + ": the checksum does not match the lines");
  return ParseLipSettings(*text, file.string()).map([](const LipSettings& read) {
    return std::optional(read);
  });
}

// A file that is missing leaves `into` empty and is no complaint; one that cannot be read leaves it as it
// was.
void ReadInto(const fs::path& file, std::optional<LipSettings>& into, std::string& complaint) {
  const auto read = ReadOne(file);
  if (read)
    into = *read;
  else
    complaint = read.error().message();
}

}  // namespace

// Of two complaints that of the newer file stays.
SavedSettings ReadGenerations(const fs::path& file) {
  SavedSettings kept;
  ReadInto(BeforeOf(file), kept.before, kept.complaint);
  ReadInto(file, kept.now, kept.complaint);
  return kept;
}

// The lips start in any case: a new box and one whose disk is broken play with the defaults.
LipSettings SettingsFrom(const fs::path& file) {
  const SavedSettings kept = ReadGenerations(file);
  if (!kept.complaint.empty())
    LogWarning(
        "{}; {}", kept.complaint,
        kept.now || !kept.before ? "the file is ignored" : "the settings that were saved before are used");
  if (kept.now) return *kept.now;
  return kept.before.value_or(LipSettings{});
}

// The older generation is whole before the newer one is touched, so that one of the two can be read at any
// time.
Result<void> WriteGeneration(const fs::path& file, const LipSettings& settings) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error) return Fail(static_cast<std::errc>(error.value()), "make the folder of " + file.string());
  const auto now = ReadOne(file);
  if (now && *now && **now != settings) {
    auto kept = WriteWholeFile(BeforeOf(file), {AsBytes(WithChecksum(**now))});
    if (!kept) return kept;
  }
  return WriteWholeFile(file, {AsBytes(WithChecksum(settings))});
}

}  // namespace kaori::lips
