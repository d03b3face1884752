#include "hw-sim/hil/data_cuts.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "hw-sim/hil/disk_copy.h"
#include "hw-sim/hil/process.h"

namespace kaori::hil {
namespace {

// What a box keeps and must not lose half of (appliance/programs, drivers/base/whole_file.h). The settings are there from the first start on.
constexpr const char* kAlwaysThere = "settings/box.toml";
constexpr std::array kKeptFiles{kAlwaysThere,           "machine-id",        "machine-id.pc",
                                "update/pending",       "update/last-try",   "shows/choice.0",
                                "shows/choice.1",       "own/last-face",     "input/turns.toml",
                                "input/last-good.toml", "lips/lips.settings"};
// By their names; a file that is not there is left out.
using Contents = std::map<std::string, std::string>;

// A write of some start, or a flush: each start begins with one, since what the machine before had written is in its file.
struct Moment {
  // Has the content; belongs to the history.
  const WriteLog* start;
  // Of no bytes: a flush.
  LoggedWrite write;
};

// The data partition's writes, their place counted from its beginning.
std::vector<Moment> MomentsOf(const UpdateHistory& history, const DiskSpan& data) {
  std::vector<Moment> moments;
  for (const WriteLog& start : history.starts()) {
    moments.push_back({&start, {}});
    for (LoggedWrite write : start.entries()) {
      if (write.bytes > 0 && !data.Holds(write)) continue;
      if (write.bytes > 0) write.at_bytes -= data.at_bytes;
      moments.push_back({&start, write});
    }
  }
  return moments;
}

// QEMU notes one where the machine's disk was asked to be safe.
bool IsFlush(const Moment& moment) {
  return moment.write.bytes == 0;
}

// The partition as a file in a folder of its own, and what is done to copies of it.
class Partition {
 public:
  Partition(Scene& scene, std::string file) : scene_(scene), file_(std::move(file)) {}

  // A part of a write, the rest of which the disk has lost. Errors: io_error.
  Result<void> Put(const Moment& moment, std::uint64_t from, std::uint64_t bytes) const {
    const auto content = moment.start->Content(moment.write);
    if (!content) return tl::unexpected(content.error());
    return WritePart(file_, moment.write.at_bytes + from, std::string_view(*content).substr(from, bytes));
  }
  // The whole of it.
  Result<void> Put(const Moment& moment) const { return Put(moment, 0, moment.write.bytes); }

  // There, lost, or torn: then a part of it is there, from its beginning or from somewhere on.
  Result<void> PutByChance(const Moment& moment) const {
    constexpr std::uint64_t kSmall_bytes = 512, kLarge_bytes = 4096;
    const int fate = std::uniform_int_distribution(0, 3)(scene_.chance);
    if (fate == 0) return {};
    if (fate == 1) return Put(moment);
    const std::uint64_t unit = fate == 2 ? kSmall_bytes : kLarge_bytes;
    const std::uint64_t cut =
        std::uniform_int_distribution<std::uint64_t>(0, moment.write.bytes / unit)(scene_.chance) * unit;
    const bool is_first_part = std::uniform_int_distribution(0, 1)(scene_.chance) == 0;
    return is_first_part ? Put(moment, 0, cut) : Put(moment, cut, moment.write.bytes - cut);
  }

  // Beside this one, in place of an earlier copy of that name. Errors: those of cp.
  Result<Partition> Copy(const char* name) const {
    std::string copy = std::filesystem::path(file_).parent_path() / name;
    if (auto ok = CopySparse(file_, copy, copy + ".log"); !ok) return tl::unexpected(ok.error());
    return Partition(scene_, std::move(copy));
  }

  // Mended as at a start, and what it holds then; nothing where it cannot be mended. e2fsck(8) ends with 1 where it has mended.
  Result<std::optional<Contents>> Mended() const {
    const std::string commands = file_ + ".commands", log = file_ + ".log";
    if (!RunToEnd({"sh", "-c", fmt::format("e2fsck -fy '{}' || [ $? -eq 1 ]", file_)}, log))
      return std::optional<Contents>();
    std::ofstream script(commands, std::ios::trunc);
    for (std::size_t n = 0; n < kKeptFiles.size(); ++n) {
      std::filesystem::remove(KeptAt(n));
      script << fmt::format("dump {} {}\n", kKeptFiles[n], KeptAt(n));
    }
    script.close();
    if (auto ok = RunToEnd({"debugfs", "-f", commands, file_}, log); !ok) return tl::unexpected(ok.error());
    Contents contents;
    for (std::size_t n = 0; n < kKeptFiles.size(); ++n)
      if (auto text = ReadFile(KeptAt(n))) contents[kKeptFiles[n]] = std::move(*text);
    return std::optional(std::move(contents));
  }

 private:
  // Where debugfs leaves a file of the partition.
  std::string KeptAt(std::size_t n) const { return fmt::format("{}.kept-{}", file_, n); }

  // For its chance.
  Scene& scene_;
  std::string file_;
};

// A partition without a journal's rest, as a start leaves it: what it holds, or a fault of this computer.
Result<Contents> SoundContents(const Partition& partition) {
  auto contents = partition.Mended();
  if (!contents) return tl::unexpected(contents.error());
  if (!*contents) return Fail(std::errc::io_error, "mend a data partition of which nothing was lost");
  if (!(*contents)->contains(kAlwaysThere))
    return Fail(std::errc::io_error, "read a data partition of which nothing was lost");
  return std::move(**contents);
}

// What is wrong with the contents after a cut; empty: nothing.
std::string FaultOf(const std::optional<Contents>& after, const Contents& flushed, const Contents& whole) {
  if (!after) return "e2fsck cannot mend it";
  const auto in = [](const Contents& contents, const char* name) {
    const auto found = contents.find(name);
    return found == contents.end() ? std::optional<std::string>() : std::optional(found->second);
  };
  for (const char* const name : kKeptFiles)
    if (const auto now = in(*after, name); now != in(flushed, name) && now != in(whole, name))
      return fmt::format("{} is {}", name, now ? "neither as before nor as after" : "lost");
  return {};
}

// The data partition of a disk, as a file.
Result<std::string> PartitionFile(Scene& scene, const std::string& disk, const DiskSpan& span) {
  const std::string folder = scene.target.machine().options().folder + "/data-cuts";
  std::filesystem::create_directories(folder);
  std::string file = folder + "/base.ext4";
  if (auto ok = CopyPart(disk, span, file, file + ".log"); !ok) return tl::unexpected(ok.error());
  return file;
}

// Whether the write has a record that makes a transaction of the journal count: jbd2's magic number and its kind 2, each of four bytes,
// the highest first (the kernel's documentation of ext4, "Journal (jbd2)").
bool Commits(std::string_view content) {
  constexpr std::string_view kCommit("\xC0\x3B\x39\x98\0\0\0\2", 8);
  constexpr std::size_t kLeastBlock_bytes = 1024;
  for (std::size_t at = 0; at < content.size(); at += kLeastBlock_bytes)
    if (content.substr(at).starts_with(kCommit)) return true;
  return false;
}

// Whether the name of a kept file stands in it, as in the folder whose entry has changed.
bool NamesKept(std::string_view content) {
  return std::ranges::any_of(kKeptFiles, [&](std::string_view name) {
    return content.find(name.substr(name.rfind('/') + 1)) != content.npos;
  });
}

// Writes of the history: all of them, and those with which a change of what is kept comes to count.
struct Writes {
  std::vector<std::size_t> all, deciding;
};

// Names of a transaction stand in blocks that are written before its record, and are forgotten behind it. A name may stand in something else
// that was written, too: such a point decides nothing, and does no harm.
Result<Writes> WritesOf(const std::vector<Moment>& moments) {
  Writes writes;
  bool names_kept = false;
  for (std::size_t n = 0; n < moments.size(); ++n) {
    if (IsFlush(moments[n])) continue;
    writes.all.push_back(n);
    const auto content = moments[n].start->Content(moments[n].write);
    if (!content) return tl::unexpected(content.error());
    names_kept = names_kept || NamesKept(*content);
    if (!Commits(*content)) continue;
    if (std::exchange(names_kept, false)) writes.deciding.push_back(n);
  }
  return writes;
}

// Writes at which the power goes, and how often: half of the cuts are anywhere, half where a change of what is kept comes to count.
Result<std::map<std::size_t, int>> PointsOf(Scene& scene, const std::vector<Moment>& moments, int cuts) {
  const auto writes = WritesOf(moments);
  if (!writes) return tl::unexpected(writes.error());
  if (writes->deciding.empty()) return FailInput("nothing that the box keeps has changed");
  std::map<std::size_t, int> points;
  for (int n = 0; n < cuts; ++n) {
    const auto& some = n % 2 == 0 ? writes->all : writes->deciding;
    ++points[some[std::uniform_int_distribution<std::size_t>(0, some.size() - 1)(scene.chance)]];
  }
  return points;
}

// What is kept where the power goes at some point: of what was flushed alone, and had nothing been lost.
struct Bounds {
  Contents flushed, whole;
};

// Of the moments from `done` on, which `base` does not have, those before `flush` were flushed, and those to `point` written.
Result<Bounds> BoundsAt(const Partition& base, const std::vector<Moment>& moments, std::size_t done,
                        std::size_t flush, std::size_t point) {
  const auto flushed = base.Copy("data-flushed"), whole = base.Copy("data-whole");
  if (!flushed || !whole) return tl::unexpected(flushed ? whole.error() : flushed.error());
  Result<void> ok;
  for (std::size_t n = done; ok && n <= point; ++n) {
    if (IsFlush(moments[n])) continue;
    if (n < flush) ok = flushed->Put(moments[n]);
    if (ok) ok = whole->Put(moments[n]);
  }
  if (!ok) return tl::unexpected(ok.error());
  auto was = SoundContents(*flushed), is = SoundContents(*whole);
  if (!was || !is) return tl::unexpected(was ? is.error() : was.error());
  return Bounds{std::move(*was), std::move(*is)};
}

// Cuts the power at a point, and says what is wrong then; empty: nothing.
Result<std::string> CutOnce(const Partition& base, const std::vector<Moment>& moments, std::size_t done,
                            std::size_t point, const Bounds& bounds) {
  const auto cut = base.Copy("data-cut");
  if (!cut) return tl::unexpected(cut.error());
  for (std::size_t n = done; n <= point; ++n)
    if (!IsFlush(moments[n]))
      if (auto ok = cut->PutByChance(moments[n]); !ok) return tl::unexpected(ok.error());
  return cut->Mended().map([&](const auto& after) { return FaultOf(after, bounds.flushed, bounds.whole); });
}

}  // namespace

// The partition goes on from flush to flush, and each cut is made on a copy of it; what bounds the cuts at one point is found once. A disk
// that lies loses of what came before the flush, too.
Result<DataCuts> CutData(Scene& scene, const UpdateHistory& history, const std::string& disk, int cuts,
                         bool lies) {
  constexpr std::size_t kLiedAbout = 40;  // Writes before the flush.
  const auto span = PartitionSpan(disk, "data");
  if (!span) return tl::unexpected(span.error());
  auto file = PartitionFile(scene, disk, *span);
  if (!file) return tl::unexpected(file.error());
  const Partition base(scene, std::move(*file));
  const auto moments = MomentsOf(history, *span);
  const auto points = PointsOf(scene, moments, cuts);
  if (!points) return tl::unexpected(points.error());
  DataCuts found;
  std::size_t done = 0;
  for (const auto& [point, times] : *points) {
    std::size_t flush = point;
    while (flush > 0 && !IsFlush(moments[flush])) --flush;
    const std::size_t sure = lies ? flush - std::min(flush, kLiedAbout) : flush;
    for (; done < sure; ++done)
      if (!IsFlush(moments[done]))
        if (auto ok = base.Put(moments[done]); !ok) return tl::unexpected(ok.error());
    const auto bounds = BoundsAt(base, moments, done, flush, point);
    if (!bounds) return tl::unexpected(bounds.error());
    for (int n = 0; n < times; ++n) {
      const auto fault = CutOnce(base, moments, done, point, *bounds);
      if (!fault) return tl::unexpected(fault.error());
      if (!fault->empty() && found.wrong++ == 0)
        found.said = fmt::format("a cut at {} of {}: {}", point, moments.size(), *fault);
    }
    found.cuts += times;
    found.deciding += bounds->flushed != bounds->whole ? times : 0;
  }
  std::error_code none;
  std::filesystem::remove_all(scene.target.machine().options().folder + "/data-cuts", none);
  return found;
}

}  // namespace kaori::hil
