// A screen in memory (Xvfb), for the window of a machine whose pictures are drawn on the bench.
#pragma once

#include <cstddef>
#include <string>

#include "drivers/base/result.h"
#include "hw-sim/hil/process.h"
#include "hw-sim/hil/waiter.h"

namespace kaori::hil {

// A rectangle of a picture, from its left top.
struct DumpPart {
  std::size_t x_px = 0, y_px = 0, width_px = 0, height_px = 0;
};

// Writes a part of an X window dump of 32 bits a point, blue first, as PNG. Errors: io_error
// (no dump, of another kind, or smaller).
Result<void> WriteDumpAsPng(const std::string& dump, const DumpPart& part, const std::string& file);

// Owns the Xvfb process; it ends with this object. Nobody else can see its screen.
class XScreen {
 public:
  // How large the machine's screen is, and where files go.
  struct Options {
    // For its picture and its log.
    std::string folder;
    // Of the machine's own screen.
    int width_px = 960;
    int height_px = 540;
  };

  // Starts Xvfb and waits until it listens, a minute at most; simulated devices play on. Errors:
  // not_supported (there is no Xvfb), timed_out.
  static Result<XScreen> Open(const Options& options, Waiter& waiter);

  const std::string& name() const { return name_; }  // ":7", for DISPLAY.

  // Writes the picture in the machine's window, as PNG: reads Xvfb's memory, in which a frame
  // may be half drawn. Errors: io_error.
  Result<void> Shoot(const std::string& file) const;

 private:
  XScreen(Process program, std::string name, std::string memory, const DumpPart& window)
      : program_(std::move(program)), name_(std::move(name)), memory_(std::move(memory)), window_(window) {}
  // Ends with this object.
  Process program_;
  std::string name_;
  // The file that is its memory: an X window dump.
  std::string memory_;
  DumpPart window_;
};

}  // namespace kaori::hil
