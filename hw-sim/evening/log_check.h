// Plays the show log of an evening again, and compares what it shows with what was shown.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "appliance/programs/stage/studio.h"
#include "drivers/base/clock.h"
#include "drivers/base/options.h"
#include "drivers/base/result.h"
#include "hw-sim/evening/verdict.h"

namespace kaori::sim {

// A picture that was drawn in the evening.
struct DrawnPicture {
  Time presented_at{};
  // Of its pixels.
  std::uint64_t sum = 0;
};

// What was shown in an evening.
struct ShownEvening {
  // In the order of time.
  std::vector<DrawnPicture> pictures;
  // The last frame of all was presented then; Time{}: there was none.
  Time last{};
};

// The sum of what the studio drew last; nothing where it cannot be read, which is no picture that could be
// compared.
std::optional<std::uint64_t> SumOfPicture(stage::Studio& studio, stage::SmallImage& into);

// Plays all logs of the folder, which are of one run of the stage, and draws anew what is in `shown`;
// pictures of a lost part of the log are not compared. Writes frames, replay_bits_differ, pictures,
// wrong_pictures, log_bytes, log_parts_lost and frame_path_allocations; adds sentences where something
// differs. Blocks for the disk, and for minutes of processor time. Errors: those of the disk and of the
// drawing.
Result<void> CheckLogs(const std::filesystem::path& folder, const ShownEvening& shown, Size size,
                       stage::Studio& studio, Verdict& into);

}  // namespace kaori::sim
