#include "hw-sim/hil/update_history.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "hw-sim/hil/disk_copy.h"

namespace kaori::hil {
namespace {

std::string FolderOf(const Scene& scene) {
  return scene.target.machine().options().folder + "/update-history";
}

}  // namespace

// Whoever cuts the power of a machine finds on its disk all that it had flushed, and of the rest what the disk pleased to
// write. Here a cut is between two writes in the order in which QEMU finished them: the disk keeps no cache of its own.
// Losses and other orders are tried without a machine, by tests/appliance/programs/update_power_cut_test.cpp, which judge
// each point of a log instead of starting from some of them.
Result<UpdateHistory> UpdateHistory::Begin(Scene& scene, const UpdatedPc& pc) {
  UpdateHistory history(FolderOf(scene));
  std::filesystem::remove_all(history.folder_);
  std::filesystem::create_directories(history.folder_);
  auto ok = CopySparse(pc.Disk(), history.Begun(), history.folder_ + "/cp.log");
  if (ok) ok = history.Rewind();
  if (!ok) return tl::unexpected(ok.error());
  return history;
}

Result<std::optional<UpdateHistory>> UpdateHistory::Kept(Scene& scene) {
  if (!std::filesystem::exists(FolderOf(scene))) return std::nullopt;
  UpdateHistory history(FolderOf(scene));
  history.Keep();
  auto ok = history.Rewind();
  while (ok && std::filesystem::exists(history.Name(history.starts_.size(), "log"))) ok = history.ReadNext();
  if (!ok) return tl::unexpected(ok.error());
  return history;
}

UpdateHistory::UpdateHistory(UpdateHistory&& other) noexcept
    : folder_(std::exchange(other.folder_, {})),
      is_kept_(other.is_kept_),
      starts_(std::move(other.starts_)),
      replayed_(other.replayed_) {}

UpdateHistory::~UpdateHistory() {
  std::error_code none;
  if (!folder_.empty() && !is_kept_) std::filesystem::remove_all(folder_, none);
}

Result<void> UpdateHistory::Rewind() {
  replayed_ = 0;
  return CopySparse(Begun(), Disk(), folder_ + "/cp.log");
}

std::string UpdateHistory::Name(std::size_t start, const char* what) const {
  return fmt::format("{}/{}.{}", folder_, start, what);
}

// The log goes with its start: the next one is noted in a file of the same name. What the firmware keeps is copied, since
// the PC goes on with it.
Result<void> UpdateHistory::Add(const UpdatedPc& pc) {
  const std::string log = Name(starts_.size(), "log"), kept = Name(starts_.size(), "variables");
  std::error_code failed;
  std::filesystem::rename(pc.DiskLog(), log, failed);
  if (!failed) std::filesystem::copy_file(pc.Variables(), kept, failed);
  if (failed) return Fail(std::errc::io_error, "keep what a start wrote");
  return ReadNext();
}

Result<void> UpdateHistory::ReadNext() {
  auto start = WriteLog::Read(Name(starts_.size(), "log"));
  if (!start) return tl::unexpected(start.error());
  starts_.push_back(std::move(*start));
  return {};
}

std::vector<LoggedWrite> UpdateHistory::Writes() const {
  std::vector<LoggedWrite> writes;
  for (const WriteLog& start : starts_)
    writes.insert(writes.end(), start.entries().begin(), start.entries().end());
  return writes;
}

// Flushes are entries, too.
std::size_t UpdateHistory::entries() const {
  return std::transform_reduce(starts_.begin(), starts_.end(), std::size_t{0}, std::plus(),
                               [](const WriteLog& start) { return start.entries().size(); });
}

// A write that only touches the span counts as well: a partition's writer may join neighbours.
std::size_t UpdateHistory::FirstInto(const DiskSpan& span) const {
  std::size_t before = 0;
  for (const WriteLog& start : starts_) {
    const auto& entries = start.entries();
    const auto found = std::ranges::find_if(entries, [&](const auto& write) { return span.Meets(write); });
    before += static_cast<std::size_t>(found - entries.begin());
    if (found != entries.end()) break;
  }
  return before;
}

std::uint64_t UpdateHistory::SectorsOutside(const std::vector<DiskSpan>& spans) const {
  return std::transform_reduce(starts_.begin(), starts_.end(), std::uint64_t{0}, std::plus(),
                               [&](const WriteLog& start) { return start.SectorsOutside(spans); });
}

// A whole copy of a disk for each cut would cost more than the cut: only what came since the last one is written.
Result<void> UpdateHistory::CutAfter(std::size_t entries, const UpdatedPc& pc) {
  if (entries < replayed_) return FailInput("a cut before the last one");
  std::size_t first = 0, start = 0;
  for (; start < starts_.size(); ++start) {
    const std::size_t count = starts_[start].entries().size();
    const std::size_t from = std::max(replayed_, first), until = std::min(entries, first + count);
    if (from < until)
      if (auto ok = starts_[start].Replay(from - first, until - first, Disk()); !ok) return ok;
    if (entries <= first + count) break;
    first += count;
  }
  replayed_ = entries;
  if (start == 0) {
    if (auto ok = pc.ForgetVariables(); !ok) return ok;
  } else {
    std::error_code failed;
    std::filesystem::copy_file(Name(std::min(start, starts_.size() - 1), "variables"), pc.Variables(),
                               std::filesystem::copy_options::overwrite_existing, failed);
    if (failed) return Fail(std::errc::io_error, "write " + pc.Variables());
  }
  return CopySparse(Disk(), pc.Disk(), folder_ + "/cp.log");
}

}  // namespace kaori::hil
