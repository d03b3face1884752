#include "appliance/programs/update/kernel_log.h"

#include "drivers/base/run_program.h"

namespace kaori::update {

Result<std::string> ReadKernelLog(const std::string& journalctl) {
  constexpr std::size_t kMostKernelLog_bytes = std::size_t{64} << 10U;
  constexpr auto kLongestReading = std::chrono::seconds(20);
  return OutputOf({journalctl, "-k", "-b", "--no-pager", "-o", "cat"}, kMostKernelLog_bytes, kLongestReading);
}

}  // namespace kaori::update
