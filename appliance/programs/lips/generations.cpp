#include "appliance/programs/lips/generations.h"

#include <system_error>

#include <fmt/format.h>

#include "drivers/base/whole_file.h"
#include "drivers/base/checksum.h"
#include "drivers/base/log.h"
#include "drivers/base/read_file.h"

namespace kaori::lips {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLipSettings_bytes = 65536;
// The first line: a file that was cut short has it too.
constexpr std::string_view kSum = "# sum ";
constexpr std::string_view kAdvice = " of all below; who changes that by hand removes this line.\n";

std::string SumLine(std::string_view text) {
  return fmt::format("{}{:016x}{}", kSum, Fnv1a(text), kAdvice);
}

std::string WithSum(const LipSettings& settings) {
  const std::string text = LipSettingsText(settings);
  return SumLine(text) + text;
}

bool SumFits(std::string_view file) {
  if (!file.starts_with(kSum)) return true;
  const auto end = file.find('\n');
  return end != std::string_view::npos && file.substr(0, end + 1) == SumLine(file.substr(end + 1));
}

fs::path BeforeOf(const fs::path& file) {
  return file.string() + ".before";
}

// Nothing where there is no file.
Result<std::optional<LipSettings>> ReadOne(const fs::path& file) {
  std::error_code none;
  if (!fs::exists(file, none)) return std::nullopt;
  const auto text = ReadFile(file, {.most_bytes = kMostLipSettings_bytes});
  if (!text) return tl::unexpected(text.error());
  if (text->find('=') == std::string::npos) return FailInput(file.string() + ": says nothing");
  if (!SumFits(*text)) return FailInput(file.string() + ": its sum does not fit its lines");
  return ParseLipSettings(*text, file.string()).map([](const LipSettings& read) {
    return std::optional(read);
  });
}

void TakeInto(const fs::path& file, std::optional<LipSettings>& into, std::string& complaint) {
  const auto read = ReadOne(file);
  if (read)
    into = *read;
  else
    complaint = read.error().message();
}

}  // namespace

Kept ReadGenerations(const fs::path& file) {
  Kept kept;
  TakeInto(BeforeOf(file), kept.before, kept.complaint);
  TakeInto(file, kept.now, kept.complaint);
  return kept;
}

LipSettings SettingsFrom(const fs::path& file) {
  const Kept kept = ReadGenerations(file);
  if (!kept.complaint.empty())
    LogWarning("{}; {}", kept.complaint,
        kept.now || !kept.before ? "going on without it" : "what was kept before that is taken");
  if (kept.now) return *kept.now;
  return kept.before.value_or(LipSettings{});
}

Result<void> WriteGeneration(const fs::path& file, const LipSettings& settings) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error) return Fail(static_cast<std::errc>(error.value()), "make the folder of " + file.string());
  const auto now = ReadOne(file);
  if (now && *now && **now != settings) {
    auto kept = WriteWholeFile(BeforeOf(file), {AsBytes(WithSum(**now))});
    if (!kept) return kept;
  }
  return WriteWholeFile(file, {AsBytes(WithSum(settings))});
}

}  // namespace kaori::lips
