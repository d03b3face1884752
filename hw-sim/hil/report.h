// The report of a bench: JUnit for machines, a page with pictures for people, figures for who compares.
#pragma once

#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "hw-sim/hil/check.h"

namespace kaori::hil {

struct ReportedCheck {
  std::string name;
  std::string sentence;
  Finding finding;
};

struct Report {
  std::string image;      // Which one.
  std::string root_hash;  // Of its root; empty where it is not known.
  double boot_s = 0;
  std::vector<ReportedCheck> checks;

  int count(Verdict verdict) const;
};

std::string AsJUnit(const Report& report);
std::string AsPage(const Report& report);

// The file name of a check's text in the report's folder: "tools-v4l2-compliance.txt".
std::string TextFile(const std::string& check, const std::string& text);

// Writes report.xml and report.html into the folder, and what tools and logs said beside them. Errors: those
// of the files.
Result<void> WriteReport(const Report& report, const std::string& folder);

// Sets what was measured in a JSON object that others write too; makes it where it is not there. Errors:
// those of the file, invalid_argument (not a JSON object).
Result<void> MergeFigures(const Report& report, const std::string& path);

}  // namespace kaori::hil
