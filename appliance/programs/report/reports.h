// The show reports that the box makes by itself, of the logs that it wrote.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace kaori::report {

// Where the box keeps what a report is made of.
struct ReportPlaces {
  // The stage's logs. Reports lie beside them, so that a backup has both: 0007-20261122-190000.report.txt and .html,
  // by the name of the evening's first log.
  std::filesystem::path logs;
  std::filesystem::path own;                 // Expressions that were made on the box.
  std::vector<std::filesystem::path> packs;  // Shows that may have been played, and folders of such.
};

// Reports are small, and tell of evenings whose logs are long gone: so many bytes of them are kept, the newest first.
inline constexpr std::uintmax_t kMostKept_bytes = std::uintmax_t{4} << 20U;
inline constexpr const char* kTextEnding = ".report.txt";
inline constexpr const char* kPageEnding = ".report.html";

struct MadeReports {
  std::vector<std::filesystem::path> files;  // The texts that were written, oldest first.
  std::vector<std::string> faults;           // Evenings that have none, each with the reason.
};

// Writes the report of each evening that has none, or whose log has grown since; evenings before it say what is usual.
// What was written before is replaced in one step or kept. Then removes the oldest reports beyond kMostKept_bytes.
// Takes seconds for an evening, and as much memory as its logs have. One process at a time.
MadeReports MakeReports(const ReportPlaces& places);

}  // namespace kaori::report
