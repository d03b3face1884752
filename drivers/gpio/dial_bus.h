// Dials on GPIO lines, as the HID device that our own dial box is.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/unique_fd.h"
#include "drivers/gpio/dial_lines.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::gpio {

// As ports::HidBus, with the one port "gpio-dials", which is there always: Open says why the lines cannot be
// had. Read of its channel also says bad_message where the kernel dropped edges: they move nothing, and the
// dials go on from their levels. One thread.
class DialBus final : public ports::HidBus {
 public:
  // Opens nothing yet. Borrows the clock. Errors: those of eventfd(2).
  static Result<std::unique_ptr<DialBus>> Open(DialLinesOpener open, const Clock& clock);

  int pollable() const override { return nothing_.get(); }
  Result<std::vector<std::string>> Ports() override;
  Result<std::unique_ptr<ports::HidChannel>> Open(const std::string& port) override;

 private:
  DialBus(DialLinesOpener open, const Clock& clock, UniqueFd nothing)
      : open_(std::move(open)), clock_(clock), nothing_(std::move(nothing)) {}

  DialLinesOpener open_;
  const Clock& clock_;
  UniqueFd nothing_;  // Never readable: lines do not come and go.
};

}  // namespace kaori::gpio
