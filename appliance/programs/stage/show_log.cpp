#include "appliance/programs/stage/show_log.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "appliance/core/showlog/log_folder.h"
#include "appliance/core/store/box_name.h"
#include "drivers/base/checksum.h"
#include "drivers/base/log.h"
#include "drivers/base/read_file.h"
#include "drivers/base/unique_fd.h"
#include "drivers/base/whole_file.h"

namespace kaori::stage {
namespace {

namespace fs = std::filesystem;

using showlog::LogOnDisk;

// Whether a stage that starts with this head goes on in that file.
// `booted_at` is worked out anew at each start and drifts with the wall clock: it is left out of the
// comparison.
bool GoesOn(const LogOnDisk& log, showlog::LogHead head) {
  if (!showlog::IsSameEvening(log.head, head) || log.bytes >= showlog::kFullFile_bytes) return false;
  head.booted_at = log.head->booted_at;
  return showlog::HeadBytes(*log.head) == showlog::HeadBytes(head);
}

// From the newest to the oldest; the first that is too much goes, and all before it. `coming` is what is
// written next.
void RemoveOld(const std::vector<LogOnDisk>& logs, const std::optional<showlog::LogHead>& current,
               std::uintmax_t coming) {
  std::uintmax_t bytes = coming;
  std::size_t evenings = 1;
  std::optional<showlog::LogHead> newer = current;
  bool full = false;
  for (auto log = logs.rbegin(); log != logs.rend(); ++log) {
    bytes += log->bytes;
    if (!showlog::IsSameEvening(log->head, newer)) ++evenings;
    newer = log->head;
    full = full || bytes > ShowLog::kMost_bytes || evenings > ShowLog::kEvenings;
    std::error_code refused;
    if (full && !fs::remove(log->file, refused) && refused)
      LogWarning("remove the old show log {}: {}", log->file.string(), refused.message());
  }
}

// A new file behind those of `logs`, named by now's wall clock; it is made when the first chunk comes.
fs::path NextFile(const fs::path& folder, const std::vector<LogOnDisk>& logs) {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  return folder / fmt::format("{:04}-{:04}{:02}{:02}-{:02}{:02}{:02}{}",
                              logs.empty() ? 1 : logs.back().number + 1, local.tm_year + 1900,
                              local.tm_mon + 1, local.tm_mday, local.tm_hour, local.tm_min, local.tm_sec,
                              showlog::kLogEnding);
}

// All or nothing: what could not be written whole is cut off again, so that the file ends with a whole chunk.
Result<void> AppendTo(int fd, std::span<const std::uint8_t> bytes, const std::string& name) {
  struct stat was {};
  if (::fstat(fd, &was) < 0) return FailErrno("write the show log " + name);
  if (auto written = WriteAll(fd, bytes, "the show log " + name); !written) {
    if (::ftruncate(fd, was.st_size) < 0) LogWarning("the show log {} has a torn part", name);
    return written;
  }
  if (::fdatasync(fd) < 0) return FailErrno("write the show log " + name);
  return {};
}

}  // namespace

// Each chunk is written as soon as the recorder hands it over. The writer is told of success in any case:
// WriteOut has logged what was refused and released the chunk, so that there is nothing to try again.
ShowLog::ShowLog(fs::path folder, const showlog::LogHead& head)
    : folder_(std::move(folder)),
      head_(showlog::HeadBytes(head)),
      booted_at_(head.booted_at),
      recorder_([this] { writer_.Ask(/*at_once=*/true); }),
      writer_(std::chrono::milliseconds(0), [this] {
        WriteOut();
        return true;  // What was refused is dropped.
      }) {}

// No file is made here: it comes with the first chunk, so that a stage that draws nothing leaves no empty
// log.
Result<std::unique_ptr<ShowLog>> ShowLog::Open(const fs::path& folder, const showlog::LogHead& head) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return Fail(static_cast<std::errc>(error.value()), "make the folder " + folder.string());
  std::unique_ptr<ShowLog> log(new ShowLog(folder, head));
  const auto logs = showlog::LogsIn(folder);
  log->file_ = !logs.empty() && GoesOn(logs.back(), head) ? logs.back().file : NextFile(folder, logs);
  RemoveOld(logs, head, 0);
  return log;
}

// A cause is told once, until a chunk reaches the disk or another cause comes. The chunk is released either
// way.
void ShowLog::WriteOut() {
  const auto chunk = recorder_.handed();
  if (chunk.empty()) return;
  const auto written = Append(chunk);
  const std::error_code cause = written ? std::error_code() : std::make_error_code(written.error().cause);
  if (cause && cause != told_) LogWarning("a part of the show log is lost: {}", written.error().message());
  told_ = cause;
  recorder_.Release();
}

// A file that is full is followed by another one; only then can there be too many.
Result<void> ShowLog::Append(std::span<const std::uint8_t> chunk) {
  std::error_code none;
  const std::uintmax_t bytes = fs::file_size(file_, none);
  if (!none && bytes >= showlog::kFullFile_bytes) {
    const auto logs = showlog::LogsIn(folder_);
    file_ = NextFile(folder_, logs);
    showlog::LogHead current;
    current.booted_at = booted_at_;
    RemoveOld(logs, current, showlog::kFullFile_bytes + showlog::kMostChunk_bytes);
  }
  const UniqueFd fd(::open(file_.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0640));
  if (!fd.valid()) return FailErrno("write the show log " + file_.string());
  struct stat was {};
  if (::fstat(fd.get(), &was) < 0) return FailErrno("write the show log " + file_.string());
  if (was.st_size == 0)
    if (auto begun = AppendTo(fd.get(), head_, file_.string()); !begun) return begun;
  return AppendTo(fd.get(), chunk, file_.string());
}

// Close hands over what there is; the writer's Finish waits for it.
void ShowLog::Finish() {
  recorder_.Close();
  writer_.Finish();
}

// What cannot be asked for stays 0 or empty: a log with half a head is still a log.
showlog::LogHead HeadOfLog(std::uint64_t show, const fs::path& roles, Time now) {
  showlog::LogHead head{.show = show};
  // The whole program: it is in the kernel's memory, since it runs.
  if (const auto program = ReadFile("/proc/self/exe", {.most_bytes = std::size_t{256} << 20U}))
    head.program = Fnv1a(*program);
  if (auto text = ReadFile(roles, {.most_bytes = showlog::kMostRoles_bytes})) head.roles = std::move(*text);
  utsname host{};
  const auto number = ReadBeginning(store::kBoxNumberFile, store::kShownDigits);
  if (::uname(&host) == 0) head.box = store::NameWithNumber(host.nodename, number.value_or(""));
  const std::time_t wall = std::time(nullptr);
  std::tm local{};
  if (::localtime_r(&wall, &local) != nullptr) head.utc_offset_s = static_cast<std::int32_t>(local.tm_gmtoff);
  head.booted_at = std::chrono::duration_cast<Duration>(std::chrono::system_clock::now().time_since_epoch()) -
                   now.time_since_epoch();
  return head;
}

}  // namespace kaori::stage
