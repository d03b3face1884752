#include "hw-sim/hil/trial.h"

#include <algorithm>

namespace kaori::hil {
namespace {

constexpr Duration kLongestTrace = std::chrono::seconds(60);

// What helps to find out why.
constexpr std::pair<const char*, const char*> kTraces[] = {
    {"the board", "board"},
    {"the box's log", "own /usr/bin/journalctl -b --no-pager -o short-monotonic -n 300"},
    {"its devices", "usb"}};

}  // namespace

ReportedCheck Trial::Try(const Check& check) {
  ReportedCheck reported{check.name, check.sentence, {}};
  Finding& finding = reported.finding;
  auto ok = StartBox(check.setup);
  const Time began = place_.clock().now();
  if (!ok && ok.error().cause == std::errc::not_supported) {
    finding.verdict = Verdict::kSkipped;
    finding.said = ok.error().message();
    return reported;
  }
  if (ok) ok = Run(check, finding);
  finding.took_s = Seconds(place_.clock().now() - began);
  if (ok) return reported;
  finding.verdict = Verdict::kFailed;
  finding.said = ok.error().message();
  AddTraces(check.name, finding);
  return reported;
}

Result<void> Trial::Run(const Check& check, Finding& finding) {
  Scene scene{.place = place_,
              .finding = finding,
              .folder = options_.report,
              .replugs = options_.replugs,
              .scenes = options_.scenes,
              .chance = chance_,
              .play = options_.play};
  return check.run(scene);
}

Result<void> Trial::StartBox(const Setup& setup) {
  const auto before = std::ranges::find(dead_, setup, &std::pair<Setup, Error>::first);
  if (before != dead_.end())
    return FailAs(before->second, "not tried: the box did not start before; " + before->second.attempt);
  auto ok = strategy_.Play(setup);
  if (!ok) dead_.emplace_back(setup, ok.error());
  if (boot_s_ == 0) boot_s_ = strategy_.boot_s();
  return ok;
}

void Trial::AddTraces(const std::string& check, Finding& finding) {
  const std::string file = check + "-failed.png";
  if (place_.machine().Shoot(0, options_.report + "/" + file))
    finding.pictures.push_back({file, "When it failed"});
  finding.texts.emplace_back("QEMU's words", place_.machine().log());
  for (const auto& [name, question] : kTraces)
    if (const auto told = place_.witness().Ask(question, kLongestTrace))
      finding.texts.emplace_back(name, *told);
}

}  // namespace kaori::hil
