#include "hw-sim/hil/machine_lines.h"

#include <utility>

#include <fmt/format.h>

namespace kaori::hil {
namespace {

constexpr Duration kLevelLongest =
    std::chrono::seconds(60);  // QEMU's main loop may wait for the guest's turn.

}  // namespace

// A machine's own devices have no names of their own: QEMU keeps them among those that are attached to none.
Result<MachineLines> MachineLines::Open(const std::string& path, Qmp& monitor, Waiter& waiter) {
  auto controller = monitor.ChildOfType("/machine/unattached", "pl061");
  if (!controller) return tl::unexpected(controller.error());
  auto stream = Stream::Call(path, waiter, kLevelLongest);
  if (!stream) return tl::unexpected(stream.error());
  return MachineLines(std::move(*stream), std::move(*controller), waiter);
}

// Each command has one line as its answer, "OK" or "FAIL" and why (qtest of QEMU).
Result<void> MachineLines::Set(int line, bool high) {
  const std::string command =
      fmt::format("set_irq_in {} unnamed-gpio-in {} {}\n", controller_, line, high ? 1 : 0);
  if (auto ok = stream_.Say(command); !ok) return ok;
  const auto answer = stream_.NextLine(*waiter_, kLevelLongest, "QEMU's test protocol");
  if (!answer) return tl::unexpected(answer.error());
  return answer->starts_with("OK") ? Result<void>{}
                                   : Fail(std::errc::invalid_argument, "set a line: " + *answer);
}

}  // namespace kaori::hil
