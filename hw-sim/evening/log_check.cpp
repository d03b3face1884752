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
// Borrows the studio and the verdict. Memory for one picture is allocated once, at 4 bytes a pixel.
class LogCheck {
 public:
  LogCheck(const ShownEvening& shown, Size size, stage::Studio& studio, Verdict& into)
      : studio_(studio),
        into_(into),
        pixels_(static_cast<std::size_t>(size.width_px) * static_cast<std::size_t>(size.height_px) * 4),
        buffer_{size.width_px, size.height_px, ports::PixelMemory{pixels_}},
        next_(shown.pictures.begin()),
        end_(shown.pictures.end()) {}

  Result<void> Check(const fs::path& file) {
    const auto log = showlog::LogFile::Read(file);
    if (!log) return tl::unexpected(log.error());
    CountLostParts(*log);
    showlog::Replay replay(*log, studio_.show());
    while (Next(replay)) {
      played_until_ = replay.presented_at();
      if (auto compared = Compare(replay); !compared) return compared;
    }
    into_.frames += replay.frames();
    into_.replay_bits_differ += replay.frames_that_differ();
    if (const auto first = replay.first_difference())
      into_.wrong.push_back(fmt::format(
          "from {} on frames of the log show something else when they play again", log->DayTimeText(*first)));
    into_.wrong.insert(into_.wrong.end(), replay.faults().begin(), replay.faults().end());
    return {};
  }

  // What was shown behind the last part of the log: as many parts as that time has, and a begun one.
  void CountLostEnd(Time last) {
    if (last > played_until_)
      into_.log_parts_lost += 1 + static_cast<std::uint64_t>((last - played_until_) / showlog::kChunkTime);
  }

 private:
  // Making the frame is what may allocate nothing; the first one of a log makes what later ones use again.
  bool Next(showlog::Replay& replay) {
    const std::size_t before = AllocationCount();
    const bool more = replay.Next();
    if (more && replay.follows()) into_.frame_path_allocations += AllocationCount() - before;
    return more;
  }

  // Numbers count on from chunk to chunk and from file to file, from 0. Frames that the recorder itself has
  // dropped are told of by the chunk that follows.
  void CountLostParts(const showlog::LogFile& log) {
    for (const showlog::Chunk& chunk : log.chunks()) {
      if (chunk.head.number > number_) into_.log_parts_lost += chunk.head.number - number_;
      if (chunk.head.lost_frames != 0) ++into_.log_parts_lost;
      number_ = chunk.head.number + 1;
    }
  }

  // Draws the frame again where the evening drew it.
  // The log keeps the time of presentation as it was, so that it is compared exactly.
  Result<void> Compare(const showlog::Replay& replay) {
    while (next_ != end_ && next_->presented_at < replay.presented_at()) ++next_;
    if (next_ == end_ || next_->presented_at != replay.presented_at()) return {};
    if (auto drawn = studio_.Draw(replay.made().scene, buffer_); !drawn) return drawn;
    ++into_.pictures;
    const auto sum = SumOfPicture(studio_, small_);
    if (sum && *sum == next_->sum) return {};
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
  std::uint32_t number_ = 0;  // Of the chunk that is next.
  Time played_until_{};       // The last frame that the log has.
};

}  // namespace

std::optional<std::uint64_t> SumOfPicture(stage::Studio& studio, stage::SmallImage& into) {
  // The picture is read in its own size: the bound is above that of any evening's screen.
  constexpr int kAnyWidth_px = 4096;
  return studio.ReadSmall(kAnyWidth_px, into) ? std::optional(Fnv1a(into.pixels)) : std::nullopt;
}

Result<void> CheckLogs(const fs::path& folder, const ShownEvening& shown, Size size, stage::Studio& studio,
                       Verdict& into) {
  const auto files = ListFolder(folder);
  if (!files) return tl::unexpected(files.error());
  // The evening drew few of its frames; now each frame that is asked for must be drawn.
  studio.DrawOneOf(1);
  LogCheck check(shown, size, studio, into);
  for (const fs::path& file : *files) {
    std::error_code none;
    into.log_bytes += fs::file_size(file, none);
    if (auto checked = check.Check(file); !checked) return checked;
  }
  check.CountLostEnd(shown.last);
  return {};
}

}  // namespace kaori::sim
