// The show report: an evening in words, as text and as a page.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "appliance/core/report/evening.h"

namespace kaori::report {

// A table of the report, in the order in which it is read: rows of as many texts as there are columns.
struct ReportTable {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  std::string none;  // What is said where there is no row.
};

// The whole report, ready to be laid out.
struct Report {
  std::string title;
  std::vector<std::string> lines;  // Facts, a sentence each.
  std::vector<ReportTable> tables;
};

// `earlier` are the evenings with which it is compared; none: there is nothing usual yet. Pure.
Report ReportOf(const Evening& evening, std::span<const Evening> earlier, const show::Show& show);

// In columns, for a terminal or a mail: UTF-8, each line as long as its widest cells make it. Pure.
std::string TextOfReport(const Report& report);
// One HTML file that needs nothing beside it, has no scripts and prints on A4; texts are escaped, since names come from a
// show that anybody may have made. Pure.
std::string PageOfReport(const Report& report);

}  // namespace kaori::report
