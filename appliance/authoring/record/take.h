// Records a take: what the operators did in a stretch of an evening, out of its show log.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "appliance/authoring/takes/take.h"
#include "appliance/core/show/show.h"
#include "appliance/core/showlog/log_file.h"
#include "drivers/base/result.h"

namespace kaori::authoring {

// Every level of the show.
inline constexpr std::uint32_t kAllLevels = ~0U;

struct RecordOptions {
  std::string name{};
  Time from{}, to{};
  // Where it is not empty, the take begins when the motion of this name began in the stretch: for a second
  // pass over a take that was played meanwhile.
  std::string with{};
  // Bit n: the level n (show::Level) is recorded. One operator's part is that of the levels of a role.
  std::uint32_t levels = kAllLevels;
  bool mouth = false;  // The mouth too, as lips, voice or dial moved it.
};

// Bits of the levels that a role has. Nothing where the show has no such role.
std::optional<std::uint32_t> LevelsOfRole(const show::Show& show, const std::string& role);

// Plays the log again through the stretch and keeps what operators did to head, gaze, brows and lids; what
// does not move has no curve, but brows have all of theirs or none. Motions that played meanwhile and what
// she does by herself are not in it. Errors: kInput: the log has nothing there, has a gap in the stretch,
// `with` did not begin in it, or nothing moved.
Result<Take> RecordTake(const showlog::LogFile& log, const show::Show& show, const RecordOptions& options);

}  // namespace kaori::authoring
