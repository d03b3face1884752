// Does a restore that waits, before any other program of the box reads what it changes.
#pragma once

#include <filesystem>
#include <functional>

#include "drivers/base/result.h"

namespace kaori::restore {

// Asked before each change of the disk; an error ends the work there, as a power cut would. For tests.
using BeforeChange = std::function<Result<void>()>;

// Puts what restore/next has to put, takes away what its plan takes away, chooses its show, and keeps what was there
// before in restore/kept. Files are moved and never copied, one after the other; where the power goes between two, the
// next call goes on. True: a restore was done or finished. Blocks for the disk. Errors: those of rename(2) and
// WriteWholeFile, after which the next call goes on; bad_message (kInput), the plan is damaged: nothing is changed.
Result<bool> FinishRestore(const std::filesystem::path& data, const BeforeChange& before = {});

}  // namespace kaori::restore
