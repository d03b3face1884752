#include "appliance/core/showlog/log_file.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

#include "drivers/base/read_file.h"

namespace kaori::showlog {
namespace {

using std::chrono::hours;

// A writer begins another file once one is full, so that a larger one was written by nobody: the chunk that
// fills it and the one behind it may go beyond.
constexpr std::size_t kLargestFile_bytes = kFullFile_bytes + 2 * kMostChunk_bytes + kMostRoles_bytes;

std::span<const std::uint8_t> BytesOf(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

// The file is at fault, and the line says so with its name.
tl::unexpected<Error> Refuse(const std::string& name, std::string_view why) {
  return FailInput(fmt::format("{}: {}", name, why), std::errc::bad_message);
}

// Of a time of day: hours begin again at 24, since an evening may last beyond midnight.
std::string ClockText(Duration day) {
  const auto s = std::chrono::duration_cast<std::chrono::seconds>(day).count();
  return fmt::format("{:02}:{:02}:{:02}", s / 3600 % 24, s / 60 % 60, s % 60);
}

}  // namespace

// What is no log at all, what is one of another version, and what is torn are told apart: the second can
// still be played with the programs that wrote it.
Result<LogFile> LogFile::Read(const std::filesystem::path& file) {
  auto text = ReadFile(file, {.most_bytes = kLargestFile_bytes});
  if (!text) return tl::unexpected(text.error());
  const std::string name = file.string();
  if (!text->starts_with(kFileMark)) return Refuse(name, "this is no show log");
  auto head = ReadHead(BytesOf(*text));
  if (!head) return Refuse(name, "the beginning of this show log is torn, or it is of another version");
  if (head->head.layout != WordsLayout())
    return Refuse(name, "another version of the programs wrote this show log, and only that one can play it");
  LogFile log(std::move(*text), std::move(head->head));
  log.FindChunks(head->bytes, name);
  if (log.chunks_.empty()) return Refuse(name, "no part of this show log is whole");
  return log;
}

// A spoilt part is passed over byte by byte until the next one begins; a mark alone is not believed without
// its sum.
void LogFile::FindChunks(std::size_t at, const std::string& name) {
  const auto bytes = BytesOf(file_);
  std::size_t whole_until = at;
  const auto name_gap = [&](std::size_t until) {
    if (until == whole_until) return;
    const std::string place =
        chunks_.empty() ? "at its beginning" : "behind the part of " + DayTimeText(chunks_.back().head.first);
    faults_.push_back(fmt::format("{}: bytes {} to {} are torn or spoilt, {}{}", name, whole_until, until,
                                  place, until == bytes.size() ? "; what is before is played" : ""));
  };
  while (at < bytes.size()) {
    if (const auto head = ReadChunkHead(bytes.subspan(at))) {
      name_gap(at);
      if (head->lost_frames > 0)
        faults_.push_back(fmt::format("{}: {} frames before {} were never written: the disk was too slow",
                                      name, head->lost_frames, DayTimeText(head->first)));
      chunks_.push_back({*head, at, bytes.subspan(at + kChunkHead_bytes, head->bytes)});
      at += kChunkHead_bytes + head->bytes;
      whole_until = at;
      continue;
    }
    at = std::min(file_.find(kChunkMark, at + 1), bytes.size());
  }
  name_gap(bytes.size());
}

// Since the midnight before the log's first frame, in the box's own time zone as it was then. It goes on
// beyond 24 hours.
Duration LogFile::DayTime(Time at) const {
  const auto local = [this](Time t) {
    return head_.booted_at + t.time_since_epoch() + std::chrono::seconds(head_.utc_offset_s);
  };
  const Duration first = local(chunks_.empty() ? at : chunks_.front().head.first);
  return local(at) - std::chrono::floor<std::chrono::days>(first);
}

std::string LogFile::DayTimeText(Time at) const {
  return ClockText(DayTime(at));
}

// A log that begins before midnight and goes on after it: 00:10 is of the next day.
std::optional<Time> LogFile::AtDayTime(std::string_view text) const {
  int hour = 0, minute = 0, second = 0, read = 0;
  const std::string asked(text);
  const int found = std::sscanf(asked.c_str(), "%2d:%2d%n:%2d%n", &hour, &minute, &read, &second, &read);
  if (found < 2 || static_cast<std::size_t>(read) != asked.size()) return std::nullopt;
  if (hour < 0 || hour > 23 || minute < 0 || minute > 59 || second < 0 || second > 59) return std::nullopt;
  const Time first = chunks_.front().head.first;
  const Duration asked_day = hours(hour) + std::chrono::minutes(minute) + std::chrono::seconds(second);
  Duration later = asked_day - DayTime(first);
  if (later < -std::chrono::seconds(1)) later += hours(24);
  return first + later;
}

// The date on which the log begins, as people in that time zone have it.
std::string LogFile::Day() const {
  const Time first = chunks_.front().head.first;
  const std::chrono::sys_days day{std::chrono::floor<std::chrono::days>(std::chrono::sys_time<Duration>(
      head_.booted_at + first.time_since_epoch() + std::chrono::seconds(head_.utc_offset_s)))};
  const std::chrono::year_month_day date(day);
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                     static_cast<unsigned>(date.day()));
}

}  // namespace kaori::showlog
