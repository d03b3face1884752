// An evening that is played again from its show log while one of its operators is live.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "appliance/core/show/show.h"
#include "appliance/core/showlog/minus_one.h"
#include "drivers/base/result.h"

namespace kaori::stage {

struct EveningOptions {
  std::string log;      // The file; empty: none is played.
  std::string without;  // The role whose operator is live, or "lips".
  std::string at;       // "19:43:10", by the clock of the evening; empty: from its beginning.
};

// A log and how it is played; the second borrows the first.
struct LoggedEvening {
  std::unique_ptr<showlog::LogFile> log;
  std::unique_ptr<showlog::MinusOne> play;
};

// Nothing where the options name no log. What of the log is spoilt is named in the program's log. `show` is
// that of `pack` with the roles that the box lays over it, which `roles` may hold, and outlives what is
// given. Blocks for the disk. Errors: those of LogFile::Read and MinusOne::Open; kInput: the log is of
// another show or other roles, or `at` is no time of day.
Result<LoggedEvening> OpenEvening(const EveningOptions& options, const std::filesystem::path& pack,
                                  const std::filesystem::path& roles, const show::Show& show);

}  // namespace kaori::stage
