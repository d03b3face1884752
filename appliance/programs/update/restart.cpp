#include "appliance/programs/update/restart.h"

#include <vector>

#include "drivers/base/log.h"
#include "drivers/base/long_call.h"
#include "drivers/base/run_program.h"

namespace kaori::update {

void RestartMachine(const std::string& systemctl, Stop stop) {
  std::vector<std::string> words{systemctl, "reboot"};
  if (stop == Stop::kAtOnce) words.emplace_back("--force");
  ExpectLongCall();
  const auto status = RunProgram(words);
  if (!status || *status != 0)
    LogError("{} reboot: {}", systemctl, status ? std::to_string(*status) : status.error().message());
}

}  // namespace kaori::update
