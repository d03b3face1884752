// The desk's end of the line to the lips: asks, hears reports, and copies pictures that were asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "appliance/programs/lips/service/words.h"
#include "drivers/base/clock.h"
#include "drivers/base/shared_memory.h"
#include "drivers/base/unique_fd.h"

namespace kaori::desk {

// One thread; nothing blocks. Lips that are gone are looked for four times a second.
class LipLine {
 public:
  explicit LipLine(std::string path) : path_(std::move(path)) {}

  void Step(Time now);

  // Where the lips answer. Their report is the newest; nothing while they are gone.
  bool live() const { return report_.has_value(); }
  const std::optional<lips::Report>& report() const { return report_; }

  // Gives the command a number of its own. Errors: no_such_device (the lips are gone).
  Result<std::uint32_t> Ask(lips::Command command);

  // Pictures come for the next two seconds. To be called as long as somebody looks.
  void Look(Time now);

  struct Picture {
    std::uint32_t number = 0;  // Counts them; 0: none yet.
    int width_px = 0;
    int height_px = 0;
    std::vector<std::uint8_t> rgbp;  // R, G, B, paint; top row first.
  };
  const Picture& picture() const { return picture_; }

 private:
  void Connect(Time now);
  void Hear();
  bool Handle(std::span<const std::uint8_t> packet, UniqueFd descriptor);
  void Copy(const lips::PictureNote& note);
  Result<void> Send(const lips::Command& command);
  void HangUp();

  std::string path_;
  UniqueFd socket_;
  SharedMemory pictures_;
  std::optional<lips::Report> report_;
  Picture picture_;
  std::uint32_t number_ = 0;
  Time retry_at_{};
  Time look_at_{};
};

}  // namespace kaori::desk
