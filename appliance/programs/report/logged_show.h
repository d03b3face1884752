// The show of a show log, as the box had it on that evening.
#pragma once

#include <filesystem>

#include "appliance/core/show/show.h"
#include "appliance/core/showlog/format.h"
#include "drivers/base/result.h"

namespace kaori::report {

// The pack, with the box's roles, which the log holds, and with the expressions that were made on the box,
// from their folder `own`; with an empty path as many that are empty, so that numbers mean the same. Passing
// files are made and removed. What of the roles is wrong is logged. Blocks for the disk. Errors: those of
// LoadPack; kInput: the log is of another show.
Result<show::Show> LoadShowOfLog(const std::filesystem::path& pack, const showlog::LogHead& head,
                                 const std::filesystem::path& own);

}  // namespace kaori::report
