// Every simulated device that an operator plays, and the one way in which an action reaches it.
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

// Members are public: whoever tests uses a device's own verbs. One thread.
struct InputDevices {
  // Borrows the context, which every device tells of what changed.
  InputDevices(const DeviceContext& context, ports::CameraFormat camera_format);

  // For every other port than kStickRight it is the left one: the caller asks for a stick's port.
  StickPod& stick(DevicePort port) { return port == DevicePort::kStickRight ? right_stick : left_stick; }

  // Does the action on the device of its port; reports become due, nothing is sent. Verbs that the device
  // does not have, numbers out of its range, and cables are ignored.
  void Do(const OperatorAction& action);

  // Each is a device of its own; the names are those of PortName.
  DialBox dial_box;
  StickPod left_stick;
  StickPod right_stick;
  Keyboard keyboard;
  Pointer pointer;
  LipCamera camera;
  Microphone microphone;
  LinePanel lines;
};

// Devices with their cables, wherever these lead: to the local link, to a virtual machine, or to real
// USB sockets. A scenario is played on one of these, and does not know which. One thread.
class DeviceRig {
 public:
  virtual ~DeviceRig() = default;
  // Lives as long as the rig.
  virtual InputDevices& devices() = 0;

  // Does one action, cables included; does not block. An action that changes nothing is no error.
  // Errors: those of the cables, such as a socket that cannot be made.
  virtual Result<void> Do(const OperatorAction& action) = 0;
};

}  // namespace kaori::sim
