// A screen in memory (Xvfb), for a machine whose pictures are drawn on the bench.
#pragma once

#include <string>

#include "drivers/base/result.h"
#include "hw-sim/bench/process.h"
#include "hw-sim/bench/waiter.h"

namespace kaori::bench {

class XScreen {
 public:
  struct Options {
    std::string folder;  // For its picture and its log.
    int width_px = 960;
    int height_px = 540;
  };

  // Errors: not_supported (there is no Xvfb), timed_out.
  static Result<XScreen> Open(const Options& options, Waiter& waiter);

  const std::string& name() const { return name_; }  // ":7", for DISPLAY.

  // What stands on it, as PNG. Errors: io_error.
  Result<void> Shoot(const std::string& file) const;

 private:
  XScreen(Process program, std::string name, std::string memory)
      : program_(std::move(program)), name_(std::move(name)), memory_(std::move(memory)) {}
  Process program_;
  std::string name_;
  std::string memory_;  // The file that is its memory: an X window dump.
};

// An X window dump of 32 bits a point, blue first, as PNG. Errors: io_error (none, or of another kind).
Result<void> WriteDumpAsPng(const std::string& dump, const std::string& file);

}  // namespace kaori::bench
