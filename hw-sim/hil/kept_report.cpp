#include "hw-sim/hil/kept_report.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::hil {
namespace {

constexpr const char* kKeptReport = "/report.json";

// Texts are left out: tools say much, and each has a file of its own beside the report.
nlohmann::json ToJson(const ReportedCheck& check) {
  const Finding& found = check.finding;
  auto pictures = nlohmann::json::array();
  for (const Picture& picture : found.pictures)
    pictures.push_back({{"file", picture.file}, {"caption", picture.caption}});
  return {{"name", check.name},
          {"sentence", check.sentence},
          {"passed", found.verdict == Verdict::kPassed},
          {"skipped", found.verdict == Verdict::kSkipped},
          {"said", found.said},
          {"pictures", std::move(pictures)},
          {"figures", found.figures},
          {"took_s", found.took_s},
          {"effort", found.effort}};
}

// Throws what nlohmann's library throws where something is missing or of another kind.
ReportedCheck FromJson(const nlohmann::json& kept) {
  ReportedCheck check{kept.at("name"), kept.at("sentence"), {}};
  check.finding.said = kept.at("said");
  check.finding.figures = kept.at("figures").get<std::map<std::string, double>>();
  check.finding.took_s = kept.at("took_s");
  check.finding.effort = kept.at("effort");
  for (const auto& picture : kept.at("pictures"))
    check.finding.pictures.push_back({picture.at("file"), picture.at("caption")});
  return check;
}

}  // namespace

// Written anew after each check: a run that is cut in the middle of a write leaves the file of the check before.
Result<void> KeepReport(const Report& report, const std::vector<ReportedCheck>& before,
                        const std::string& trial, const std::string& folder) {
  auto checks = nlohmann::json::array();
  for (const ReportedCheck& check : report.checks) checks.push_back(ToJson(check));
  for (const ReportedCheck& check : before)
    if (std::ranges::find(report.checks, check.name, &ReportedCheck::name) == report.checks.end())
      checks.push_back(ToJson(check));
  const nlohmann::json kept{
      {"trial", trial}, {"files", report.files}, {"wanted", report.wanted}, {"checks", std::move(checks)}};
  // What a tool said may be no UTF-8.
  const std::string text = kept.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  return WriteWholeFile(folder + kKeptReport, {AsBytes(text)});
}

// A file that somebody has changed is no report: all is tried then.
std::vector<ReportedCheck> KeptPasses(const std::string& trial, int effort, const std::string& folder) {
  const auto text = ReadFile(folder + kKeptReport, {.most_levels = kMostLevels});
  if (!text) return {};
  const auto kept = nlohmann::json::parse(*text, nullptr, false);
  std::vector<ReportedCheck> passes;
  try {
    if (kept.is_discarded() || kept.at("trial") != trial) return {};
    for (const auto& check : kept.at("checks")) {
      const bool enough = check.at("effort") == 0 || check.at("effort") >= effort;
      if (enough && check.at("passed") == true) passes.push_back(FromJson(check));
    }
  } catch (const nlohmann::json::exception&) {
    return {};
  }
  return passes;
}

}  // namespace kaori::hil
