#include "hw-sim/hil/failure_traces.h"

#include <utility>

namespace kaori::hil {
namespace {

// Of a box that has just failed: it may not answer at all.
constexpr Duration kLongestTrace = std::chrono::seconds(60);

// The first word of each pair is the heading in the report, the second the question to the agent.
constexpr std::pair<const char*, const char*> kTraces[] = {
    {"the board", "board"},
    {"the kernel's faults", kFaultsQuestion},
    {"the box's log", "own /usr/bin/journalctl -b --no-pager -o short-monotonic -n 300"},
    {"its devices", "usb"}};

}  // namespace

void AddTraces(Target& target, const std::string& folder, const std::string& name, Finding& finding) {
  const std::string file = name + "-failed.png";
  if (target.machine().Shoot(0, folder + "/" + file)) finding.pictures.push_back({file, "When it failed"});
  for (const auto& [heading, question] : kTraces)
    if (const auto told = target.agent().Ask(question, kLongestTrace); told && !told->empty())
      finding.texts.emplace_back(heading, *told);
}

}  // namespace kaori::hil
