// What a run has found is kept beside its report, so that a run of hours that was cut goes on where it was.
#pragma once

#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "hw-sim/hil/report.h"

namespace kaori::hil {

// Writes report.json into the folder, as a whole: what was found, and of which trial. `trial` says all that a finding depends on: the
// image, the bench's own program, how often was tried what all checks try; the effort is kept with those that asked for it. What has
// passed `before` and was not come to yet stays kept. By the image's files and the number of checks that are wanted rootfs/image/tested.py
// tells whether an update may be made. Pictures and texts are in files of the report and are only named. Errors: those of the file.
Result<void> KeepReport(const Report& report, const std::vector<ReportedCheck>& before,
                        const std::string& trial, const std::string& folder);

// Of the kept report of this very trial the checks that have passed, with this effort at least where they asked for it; the others are to
// be tried again. Texts are left out, since their files are there. Empty where none is kept, where it is of another trial, or no report.
std::vector<ReportedCheck> KeptPasses(const std::string& trial, int effort, const std::string& folder);

}  // namespace kaori::hil
