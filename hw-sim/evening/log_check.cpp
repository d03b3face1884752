#include "hw-sim/evening/log_check.h"

#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "appliance/core/showlog/log_file.h"
#include "appliance/core/showlog/replay.h"
#include "drivers/base/checksum.h"
#include "drivers/base/folder.h"
#include "hw-sim/evening/allocations.h"

namespace kaori::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostSentences =
    10;  // Of one kind: a log that differs once may differ in all that follows.

// One evening's logs, one file after the other.
class LogCheck {
 public:
  LogCheck(const std::vector<DrawnPicture>& pictures, Size size, stage::Studio& studio, Verdict& into)
      : studio_(studio),
        into_(into),
        pixels_(static_cast<std::size_t>(size.width_px) * static_cast<std::size_t>(size.height_px) * 4),
        buffer_{size.width_px, size.height_px, ports::PixelMemory{pixels_}},
        next_(pictures.begin()),
        end_(pictures.end()) {}

  Result<void> Check(const fs::path& file) {
    const auto log = showlog::LogFile::Read(file);
    if (!log) return tl::unexpected(log.error());
    CountLostParts(*log);
    showlog::Replay replay(*log, studio_.show());
    while (Next(replay))
      if (auto compared = Compare(replay); !compared) return compared;
    into_.frames += replay.frames();
    into_.replay_bits_differ += replay.frames_that_differ();
    if (const auto first = replay.first_difference())
      into_.wrong.push_back(fmt::format(
          "from {} on frames of the log show something else when they play again", log->DayTimeText(*first)));
    into_.wrong.insert(into_.wrong.end(), replay.faults().begin(), replay.faults().end());
    return {};
  }

 private:
  // Making the frame is what may allocate nothing; the first one of a log makes what later ones use again.
  bool Next(showlog::Replay& replay) {
    const std::size_t before = AllocationCount();
    const bool more = replay.Next();
    if (more && replay.follows()) into_.frame_path_allocations += AllocationCount() - before;
    return more;
  }

  // Numbers count on from chunk to chunk and from file to file. Frames that the recorder itself has dropped
  // are told of by the chunk that follows.
  void CountLostParts(const showlog::LogFile& log) {
    for (const showlog::Chunk& chunk : log.chunks()) {
      if (number_ && chunk.head.number > *number_ + 1)
        into_.log_parts_lost += chunk.head.number - *number_ - 1;
      if (chunk.head.lost_frames != 0) ++into_.log_parts_lost;
      number_ = chunk.head.number;
    }
  }

  // Draws the frame again where the evening drew it.
  Result<void> Compare(const showlog::Replay& replay) {
    while (next_ != end_ && next_->presented_at < replay.presented_at()) ++next_;
    if (next_ == end_ || next_->presented_at != replay.presented_at()) return {};
    if (auto drawn = studio_.Draw(replay.made().scene, buffer_); !drawn) return drawn;
    ++into_.pictures;
    if (SumOfPicture(studio_, small_) == next_->sum) return {};
    if (++into_.wrong_pictures <= kMostSentences)
      into_.wrong.push_back(
          fmt::format("the picture {:.1f} s after the machine's start is another one from the log",
                      Seconds(next_->presented_at.time_since_epoch())));
    return {};
  }

  stage::Studio& studio_;
  Verdict& into_;
  std::vector<std::uint8_t> pixels_;
  ports::PixelBuffer buffer_;
  stage::SmallImage small_;
  std::vector<DrawnPicture>::const_iterator next_, end_;
  std::optional<std::uint32_t> number_;  // Of the chunk before.
};

}  // namespace

std::uint64_t SumOfPicture(stage::Studio& studio, stage::SmallImage& into) {
  constexpr int kAnyWidth_px = 4096;
  return studio.ReadSmall(kAnyWidth_px, into) ? Fnv1a(into.pixels) : 0;
}

Result<void> CheckLogs(const fs::path& folder, const std::vector<DrawnPicture>& pictures, Size size,
                       stage::Studio& studio, Verdict& into) {
  const auto files = ListFolder(folder);
  if (!files) return tl::unexpected(files.error());
  studio.DrawOneOf(1);
  LogCheck check(pictures, size, studio, into);
  for (const fs::path& file : *files) {
    std::error_code none;
    into.log_bytes += fs::file_size(file, none);
    if (auto checked = check.Check(file); !checked) return checked;
  }
  return {};
}

}  // namespace kaori::sim
