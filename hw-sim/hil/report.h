// The report of a bench: JUnit for machines, a page with pictures for people, figures for who compares.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "hw-sim/hil/check.h"

namespace kaori::hil {

// A check with what was found, as it goes into the report.
struct ReportedCheck {
  // As Check has it.
  std::string name;
  std::string sentence;
  Finding finding;
};

// All that a run has found, in the order of its checks.
struct Report {
  // Which one.
  std::string image;
  // Of its root; empty where it is not known.
  std::string root_hash;
  // As UpdateFileHashes gives them: an update is made of what was tried.
  std::map<std::string, std::string> files{};
  // How many checks the run is to have when it has come to its end.
  std::size_t wanted = 0;
  // From power to the first frames of the first box; 0 where none played.
  double boot_s = 0;
  // In the order in which they were run.
  std::vector<ReportedCheck> checks;

  // How many checks have this verdict.
  int count(Verdict verdict) const;
};

// The report as JUnit's XML, one testcase for each check, as test servers read it. Pure.
std::string AsJUnit(const Report& report);
// The report as one page of HTML; pictures are beside it. Pure.
std::string AsPage(const Report& report);

// The file name of a check's text in the report's folder: "tools-v4l2-compliance.txt". Pure.
std::string TextFile(const std::string& check, const std::string& text);

// Writes report.xml and report.html into the folder, and what tools and logs said beside them. Each file
// is replaced as a whole. Blocks for the disk. Errors: those of the files.
Result<void> WriteReport(const Report& report, const std::string& folder);

// Sets what checks that have passed measured in a JSON object that others write too; makes it where it is not there. A check that
// has failed leaves no figures, those of a run before neither: the object's entry "figures_of_checks" says whose are which. Other
// entries stay, in the order of their names, also those of checks that were skipped or not tried. Errors: those of the file,
// invalid_argument (not a JSON object).
Result<void> MergeFigures(const Report& report, const std::string& path);

}  // namespace kaori::hil
