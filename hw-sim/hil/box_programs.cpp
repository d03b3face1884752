#include "hw-sim/hil/box_programs.h"

#include <algorithm>
#include <array>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "drivers/base/number.h"

namespace kaori::hil {
namespace {

constexpr std::array kUnits{"kaori-stage.service", "kaori-fdkeeper.service", "kaori-input.service",
                            "kaori-lips.service"};
constexpr Duration kProgramsAnswer = std::chrono::minutes(2);
constexpr std::string_view kOfAService = ".service";

// A number that is none counts as 0, which no process has.
int NumberIn(std::string_view value) {
  return ParseNumber<int>(value).value_or(0);
}

}  // namespace

Result<std::vector<BoxProgram>> LookAtPrograms(AgentProtocol& agent) {
  const auto said =
      agent.Ask(fmt::format("own /usr/bin/systemctl show -p Id,MainPID,NRestarts {}", fmt::join(kUnits, " ")),
                kProgramsAnswer);
  if (!said) return tl::unexpected(said.error());
  auto programs = ReadPrograms(*said);
  if (programs.size() == kUnits.size()) return programs;
  return Fail(std::errc::io_error, "read of the box's programs: " + *said);
}

// A unit's lines come in the service manager's own order: its name may be the last of them.
std::vector<BoxProgram> ReadPrograms(std::string_view said) {
  std::vector<BoxProgram> programs;
  BoxProgram program;
  std::istringstream lines{std::string(said) + "\n\n"};
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = std::min(line.find('='), line.size());
    const std::string_view name = std::string_view(line).substr(0, equals);
    const std::string_view value = std::string_view(line).substr(std::min(equals + 1, line.size()));
    if (name == "MainPID") program.process = NumberIn(value);
    if (name == "NRestarts") program.restarts = NumberIn(value);
    if (name == "Id") program.name = value.substr(0, value.find(kOfAService));
    if (!line.empty()) continue;
    if (!program.name.empty()) programs.push_back(program);
    program = {};
  }
  return programs;
}

// The count tells of a program that was between two lives at the first look, and had no process then.
std::string EndedSince(const std::vector<BoxProgram>& before, const std::vector<BoxProgram>& now) {
  for (const BoxProgram& was : before) {
    const auto is = std::ranges::find(now, was.name, &BoxProgram::name);
    const bool same = is != now.end() && is->process == was.process && is->restarts == was.restarts;
    const bool started = is != now.end() && was.process == 0 && is->restarts == was.restarts;
    if (same || started) continue;
    const bool runs = is != now.end() && is->process != 0;
    return was.name + " has ended meanwhile" + (runs ? " and was started again" : "");
  }
  return {};
}

}  // namespace kaori::hil
