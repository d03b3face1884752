// Any text as a scenario: it is read or refused, and what was read is written and read again the same.
#include <cstdint>
#include <string_view>

#include "hw-sim/scenario/reader.h"
#include "hw-sim/scenario/writer.h"
#include "tests/fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kaori;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const sim::Reading reading = sim::ReadScenario(text);
  for (const sim::Problem& problem : reading.problems)
    fuzz::Promise(problem.line >= 1 && problem.column >= 1 && !problem.what.empty(),
                  "a problem says where and what");
  if (!reading.problems.empty()) return 0;
  for (const sim::TimedAction& action : reading.scenario.actions)
    fuzz::Promise(action.at >= Duration::zero() && action.at + action.over <= reading.scenario.length,
                  "every action lies within the play");
  const std::string written = sim::WriteScenario(reading.scenario);
  const sim::Reading again = sim::ReadScenario(written);
  fuzz::Promise(again.problems.empty(), "what was written can be read");
  fuzz::Promise(sim::WriteScenario(again.scenario) == written, "and says the same");
  return 0;
}
