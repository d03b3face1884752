#include "hw-sim/hil/kept_report.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::hil {
namespace {

constexpr const char* kKeptReport = "/report.json";
// Of a check that has not passed: what its rounds before have found.
constexpr const char* kPassedRounds = "passed_rounds";

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
          {"counts", found.counts},
          {"control", found.control},
          {"took_s", found.took_s},
          {"rounds", found.rounds}};
}

// Throws what nlohmann's library throws where something is missing or of another kind.
ReportedCheck FromJson(const nlohmann::json& kept) {
  ReportedCheck check{kept.at("name"), kept.at("sentence"), {}};
  check.finding.said = kept.at("said");
  check.finding.figures = kept.at("figures").get<std::map<std::string, double>>();
  check.finding.counts = kept.at("counts").get<std::map<std::string, double>>();
  check.finding.control = kept.at("control");
  check.finding.took_s = kept.at("took_s");
  check.finding.rounds = kept.at("rounds");
  for (const auto& picture : kept.at("pictures"))
    check.finding.pictures.push_back({picture.at("file"), picture.at("caption")});
  return check;
}

}  // namespace

// Written anew after each round: a run that is cut in the middle of a write leaves the file of the round before.
Result<void> KeepReport(const Report& report, const std::vector<ReportedCheck>& passes,
                        const std::string& trial, const std::string& folder) {
  auto checks = nlohmann::json::array();
  for (const ReportedCheck& check : report.checks) checks.push_back(ToJson(check));
  for (const ReportedCheck& pass : passes) {
    const auto reported = std::ranges::find(report.checks, pass.name, &ReportedCheck::name);
    if (reported == report.checks.end())
      checks.push_back(ToJson(pass));
    else if (reported->finding.verdict != Verdict::kPassed)
      checks[static_cast<std::size_t>(reported - report.checks.begin())][kPassedRounds] = ToJson(pass);
  }
  const nlohmann::json kept{
      {"trial", trial}, {"files", report.files}, {"wanted", report.wanted}, {"checks", std::move(checks)}};
  // What a tool said may be no UTF-8.
  const std::string text = kept.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  return WriteWholeFile(folder + kKeptReport, {AsBytes(text)});
}

// A file that somebody has changed is no report: all is tried then.
std::vector<ReportedCheck> KeptPasses(const std::string& trial, const std::string& folder) {
  const auto text = ReadFile(folder + kKeptReport, {.most_levels = kMostLevels});
  if (!text) return {};
  const auto kept = nlohmann::json::parse(*text, nullptr, false);
  std::vector<ReportedCheck> passes;
  try {
    if (kept.is_discarded() || kept.at("trial") != trial) return {};
    for (const auto& check : kept.at("checks")) {
      if (check.at("passed") == true)
        passes.push_back(FromJson(check));
      else if (check.contains(kPassedRounds))
        passes.push_back(FromJson(check.at(kPassedRounds)));
    }
  } catch (const nlohmann::json::exception&) {
    return {};
  }
  return passes;
}

}  // namespace kaori::hil
