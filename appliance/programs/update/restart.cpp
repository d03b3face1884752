#include "appliance/programs/update/restart.h"

#include <vector>

#include "drivers/base/log.h"
#include "drivers/base/long_call.h"
#include "drivers/base/run_program.h"

namespace kaori::update {

Result<void> RestartMachine(const std::string& systemctl, Stop stop) {
  std::vector<std::string> words{systemctl, "reboot"};
  if (stop == Stop::kAtOnce) words.emplace_back("--force");
  ExpectLongCall();
  const auto status = RunProgram(words);
  if (!status) return tl::unexpected(status.error());
  if (*status == 0) return {};
  return Fail(std::errc::io_error, systemctl + " reboot, which ended with " + std::to_string(*status));
}

void RestartOrSay(const std::string& systemctl) {
  if (auto told = RestartMachine(systemctl); !told) LogError("{}", told.error().message());
}

}  // namespace kaori::update
