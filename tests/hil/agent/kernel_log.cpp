#include "tests/hil/agent/kernel_log.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "hw-sim/hil/kernel_fault.h"

namespace kaori::agent {
namespace {

// The kernel gives one record at a time, and no longer one (PRINTK_MESSAGE_MAX).
constexpr std::size_t kRecord_bytes = 8192;

}  // namespace

Result<KernelLog> KernelLog::Open(From from) {
  UniqueFd log(::open("/dev/kmsg", O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!log.valid()) return FailErrno("open /dev/kmsg");
  if (from == From::kNow) ::lseek(log.get(), 0, SEEK_END);
  return KernelLog(std::move(log));
}

std::vector<std::string> KernelLog::NewFaults() {
  std::vector<std::string> faults;
  std::array<char, kRecord_bytes> record;
  while (true) {
    const ssize_t got = ::read(log_.get(), record.data(), record.size());
    // Records were overwritten before they were read: the next read goes on behind them.
    if (got < 0 && (errno == EPIPE || errno == EINTR)) continue;
    if (got <= 0) return faults;
    auto fault = FaultIn(std::string(record.data(), static_cast<std::size_t>(got)));
    if (!fault.empty()) faults.push_back(std::move(fault));
  }
}

// "PRIORITY,NUMBER,MICROSECONDS,FLAGS;TEXT", and lines of further fields (Documentation/ABI/testing/dev-kmsg).
std::string FaultIn(const std::string& record) {
  const std::size_t at = record.find(';');
  if (at == std::string::npos) return {};
  std::string text = record.substr(at + 1, record.find('\n', at) - at - 1);
  return hil::TellsOfKernelFault(text) ? text : std::string();
}

}  // namespace kaori::agent
