// A stick's file system is the one thing that somebody unknown gives to the kernel: damaged ones end nothing.
#include <cstdint>
#include <sstream>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/kernel_fault.h"
#include "hw-sim/hil/paused_unit.h"

namespace kaori::hil {
namespace {

constexpr std::uint64_t kDamagedDisks = 10'000;
constexpr std::uint64_t kOneBatch = 250;
// A driver that hangs does so for ever. A batch takes seconds, and a minute on a busy computer; the first
// one makes the good file systems, too.
constexpr Duration kLongestBatch = std::chrono::minutes(10);
constexpr Duration kLongestFrame = std::chrono::minutes(2);
// Where only the boot sector of most was changed, few are mounted, and little is tried.
constexpr double kLeastMounted = 0.3;
// The agent writes to one of ten. A driver may refuse many of these, and where it refuses nearly all little is tried.
constexpr double kLeastWritten = 0.02;

// What became of images so far.
struct Damaged {
  std::uint64_t tried = 0, mounted = 0, entries = 0, written = 0, hung = 0;
  std::string fault{};  // Of the kernel, with the image's number; empty: none.
};

// One batch. A batch without an answer counts as one image that hung: which one, the kernel does not say.
// Errors: those of the agent, but for timed_out.
Result<void> TryBatch(Scene& scene, std::uint64_t first, std::uint64_t count, Duration longest,
                      Damaged& all) {
  const auto said = scene.target.agent().Ask(fmt::format("damaged-disks {} {}", first, count), longest);
  if (!said && said.error().cause == std::errc::timed_out) {
    ++all.hung;
    return {};
  }
  if (!said) return tl::unexpected(said.error());
  std::istringstream words(*said);
  std::string word;
  std::uint64_t tried = 0, mounted = 0, entries = 0, bytes = 0, written = 0;
  if (!(words >> word >> tried >> word >> mounted >> word >> entries >> word >> bytes >> word >> written))
    return FailInput("the agent says of damaged disks: " + *said);
  all.tried += tried;
  all.mounted += mounted;
  all.entries += entries;
  all.written += written;
  if (const auto at = said->find(" fault "); at != std::string::npos) all.fault = said->substr(at + 1);
  return {};
}

// Errors: invalid_argument, where a driver hung, the kernel tells of a fault, or too little was tried.
Result<void> Judge(const Damaged& all, std::uint64_t wanted) {
  if (all.hung > 0)
    return FailInput(fmt::format("the kernel hangs on one of the images behind {}", all.tried));
  if (!all.fault.empty()) return FailInput("the kernel says: " + all.fault);
  if (all.tried != wanted)
    return FailInput(fmt::format("{} images were tried, and not {}", all.tried, wanted));
  if (static_cast<double>(all.mounted) < kLeastMounted * static_cast<double>(wanted) || all.entries == 0)
    return FailInput(fmt::format("only {} of {} images were mounted", all.mounted, wanted));
  if (static_cast<double>(all.written) < kLeastWritten * static_cast<double>(wanted))
    return FailInput(fmt::format("only {} of {} images were written to", all.written, wanted));
  return {};
}

// The stage draws on: that kernel's screen is seen by its own machine alone.
Result<void> WantFrames(Scene& scene) {
  const auto now = scene.target.Board();
  if (!now) return tl::unexpected(now.error());
  const auto more = [&](const BoardView& board) {
    return board.stage.live && board.stage.frames > now->stage.frames;
  };
  const auto seen = scene.target.UntilBoard(more, kLongestFrame, "see another frame");
  if (!seen) return tl::unexpected(seen.error());
  return {};
}

// Batches [first, end), until one finds something.
Result<void> TryBatches(Scene& scene, std::uint64_t first, std::uint64_t end, Damaged& all) {
  for (; first < end && all.hung == 0 && all.fault.empty(); first += kOneBatch)
    if (auto ok = TryBatch(scene, first, kOneBatch, kLongestBatch, all); !ok) return ok;
  return {};
}

// A stage that draws takes all that an emulated machine's processors give, so that most are tried without it: it draws beside the last
// ones.
Result<void> DamagedSticks(Scene& scene) {
  constexpr std::uint64_t kBesideTheStage = 2 * kOneBatch;
  Damaged all;
  {
    const PausedUnit stage(scene, "kaori-stage.service");
    if (auto ok = TryBatches(scene, 0, kDamagedDisks - kBesideTheStage, all); !ok) return ok;
  }
  if (auto ok = WantFrames(scene); !ok) return ok;
  if (auto ok = TryBatches(scene, kDamagedDisks - kBesideTheStage, kDamagedDisks, all); !ok) return ok;
  auto& figures = scene.finding.figures;
  figures["fat_images"] = static_cast<double>(all.tried);
  figures["fat_images_hung"] = static_cast<double>(all.hung);
  figures["fat_images_mounted"] = static_cast<double>(all.mounted);
  figures["fat_images_written"] = static_cast<double>(all.written);
  if (auto ok = Judge(all, kDamagedDisks); !ok) return ok;
  scene.finding.said =
      fmt::format("{} damaged file systems, {} of them mounted all the same, {} entries read, {} written to",
                  all.tried, all.mounted, all.entries, all.written);
  return WantFrames(scene);
}

// The control: a fault of the kernel during a batch is found, and so is a batch of which nothing was written to, and one that gives no
// answer in time.
Result<void> FaultsAreSeen(Scene& scene) {
  Damaged planted;
  if (auto said = scene.target.agent().Ask(fmt::format("write /dev/kmsg {}", kPlantedFault), kLongestBatch);
      !said)
    return tl::unexpected(said.error());
  if (auto ok = TryBatch(scene, 0, kOneBatch, kLongestBatch, planted); !ok) return ok;
  if (auto ok = WantFoundWrong(Judge(planted, kOneBatch), "a fault of the kernel is not seen"); !ok)
    return ok;
  planted.fault.clear();
  if (auto ok = Judge(planted, kOneBatch); !ok) return ok;
  planted.written = 0;
  if (auto ok = WantFoundWrong(Judge(planted, kOneBatch), "nobody misses the writing"); !ok) return ok;
  Damaged late;
  if (auto ok = TryBatch(scene, 0, kOneBatch, std::chrono::milliseconds(1), late); !ok) return ok;
  return WantFoundWrong(Judge(late, kOneBatch), "a kernel that hangs is not seen");
}

}  // namespace

std::vector<Check> DamagedDiskChecks() {
  return {
      {.name = "damaged-sticks",
       .sentence = "Damaged file systems of sticks do not stop the kernel",
       .run = DamagedSticks,
       // The bench's kernel has the same drivers of file systems, and a disk in memory.
       .setup = {.plugged = false, .sound = false, .bench_kernel = true, .width_px = 320, .height_px = 180},
       .control = FaultsAreSeen,
       .ends_programs = true}};
}

}  // namespace kaori::hil
