// What a run has found is kept beside its report, so that a run of hours that was cut goes on where it was.
#pragma once

#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "hw-sim/hil/report.h"

namespace kaori::hil {

// Writes report.json into the folder, as a whole: what was found, and of which trial. `trial` says all that a finding depends on but the
// number of rounds, which each finding has: the image, the bench's own program, how often cables are pulled. `passes` are the rounds that
// have passed, of this run and of those before it; they stay kept where the check was not come to yet, and where a later round of it has
// not passed. By the image's files and the number of checks that are wanted rootfs/image/tested.py
// tells whether an update may be made. Pictures and texts are in files of the report and are only named. Errors: those of the file.
Result<void> KeepReport(const Report& report, const std::vector<ReportedCheck>& passes,
                        const std::string& trial, const std::string& folder);

// Of the kept report of this very trial the rounds that have passed, of each check that has any; all else is to be tried. Texts are left out, since their files are there. Empty where none is kept, where it is of another trial, or no report.
std::vector<ReportedCheck> KeptPasses(const std::string& trial, const std::string& folder);

}  // namespace kaori::hil
