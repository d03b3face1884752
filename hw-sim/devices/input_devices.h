// Every simulated device that hands play, and the one way in which a hand reaches it.
#pragma once

#include "drivers/base/result.h"
#include "hw-sim/devices/dial_box.h"
#include "hw-sim/devices/keyboard.h"
#include "hw-sim/devices/line_panel.h"
#include "hw-sim/devices/lip_camera.h"
#include "hw-sim/devices/microphone.h"
#include "hw-sim/devices/operator_action.h"
#include "hw-sim/devices/pointer.h"
#include "hw-sim/devices/stick_pod.h"

namespace kaori::sim {

struct InputDevices {
  // Borrows the context.
  InputDevices(const DeviceContext& context, ports::CameraFormat camera_format);

  StickPod& stick(DevicePort port) { return port == DevicePort::kStickRight ? right_stick : left_stick; }

  // Verbs that the place does not have, and cables, are ignored.
  void Do(const OperatorAction& action);

  DialBox dial_box;
  StickPod left_stick;
  StickPod right_stick;
  Keyboard keyboard;
  Pointer pointer;
  LipCamera camera;
  Microphone microphone;
  LinePanel lines;
};

// Devices with their cables, wherever these lead: what a scenario is played on.
class DeviceRig {
 public:
  virtual ~DeviceRig() = default;
  virtual InputDevices& devices() = 0;

  // Does one hand, cables included. Errors: those of the cables.
  virtual Result<void> Do(const OperatorAction& action) = 0;
};

}  // namespace kaori::sim
