// A stage for the console's tests: reads the devices with the product's drivers, draws what they say, says it
// aloud.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/decode/dial_box.h"
#include "drivers/decode/joystick.h"
#include "drivers/decode/keyboard.h"
#include "drivers/decode/pointer.h"
#include "drivers/gpio/local_lines.h"
#include "drivers/ports/hid_channel.h"
#include "drivers/ports/loudspeaker.h"
#include "drivers/ports/scanout.h"

namespace kaori::console {

// Pushing a button switches its lamp. What the drivers decode goes to standard output, one line for each
// change: "dial 1 64" (counts), "button 3 1", "key 44 1", "stick-left 0.50 0.00 0.00 0.00" (x, y, twist,
// slider), "pointer 0.25 0.75 1 0" (x, y, buttons, wheel), "line 0 1". The tally lamp is lit while line 1 is off; the
// loudspeaker plays a tone of 440 Hz without end.
class ToyStage {
 public:
  static Result<std::unique_ptr<ToyStage>> Open(const std::string& folder);

  // Reads what waits, and draws a frame when the screen can take one. Does not block.
  void Step();

 private:
  ToyStage(std::string folder, std::unique_ptr<ports::HidBus> bus);
  void OpenPorts();
  // Reads what waits at a port. False once its device has gone.
  bool Read(const std::string& port, ports::HidChannel& channel);
  bool ReadDialBox(ports::HidChannel& channel);
  bool ReadStick(ports::HidChannel& channel);
  bool ReadKeyboard(ports::HidChannel& channel);
  bool ReadPointer(ports::HidChannel& channel);
  void TellDialBox(const decode::DialSample& before, const decode::DialSample& now,
                   ports::HidChannel& channel);
  void ReadLines();
  void Sound();
  void Draw();
  void DrawHand(const ports::PixelBuffer& into, std::size_t dial) const;

  std::string folder_;
  std::unique_ptr<ports::HidBus> bus_;
  std::map<std::string, std::unique_ptr<ports::HidChannel>> channels_;
  std::optional<decode::DialBoxDecoder> dial_box_;
  std::map<std::string, decode::JoystickDecoder> sticks_;
  std::optional<decode::KeyboardDecoder> keyboard_;
  std::optional<decode::PointerDecoder> pointer_;
  std::uint32_t lamps_ = 0;
  std::unique_ptr<gpio::LocalLines> lines_;
  bool lines_greeted_ = false;
  std::unique_ptr<ports::Loudspeaker> loudspeaker_;
  SteadyClock clock_;
  std::uint64_t played_frames_ = 0;
  std::unique_ptr<ports::Scanout> screen_;
  std::uint64_t frame_ = 0;
  std::vector<std::uint8_t> backdrop_;  // RGBX, as large as the screen.
};

}  // namespace kaori::console
