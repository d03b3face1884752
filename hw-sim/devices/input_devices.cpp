#include "hw-sim/devices/input_devices.h"

namespace kaori::sim {
namespace {

// Each of these passes an action's verb on to the device; verbs that the
// device does not have fall through.
void DoOnBox(DialBox& box, const OperatorAction& action) {
  if (action.verb == Verb::kTurn) box.Turn(action.index, action.a);
  if (action.verb == Verb::kPush) box.Push(action.index);
  if (action.verb == Verb::kRelease) box.Release(action.index);
}

void DoOnStick(StickPod& stick, const OperatorAction& action) {
  const auto a = static_cast<float>(action.a);
  if (action.verb == Verb::kMove) stick.Move(a, static_cast<float>(action.b));
  if (action.verb == Verb::kTwist) stick.Twist(a);
  if (action.verb == Verb::kSlide) stick.Slide(a);
  if (action.verb == Verb::kHat) stick.Hat(action.index);
  if (action.verb == Verb::kPush) stick.Push(action.index);
  if (action.verb == Verb::kRelease) stick.Release(action.index);
}

// There are no keys beyond usage 255: a report could not name them.
void DoOnKeyboard(Keyboard& keyboard, const OperatorAction& action) {
  if (action.index < 0 || action.index > 0xFF) return;
  const auto usage = static_cast<std::uint8_t>(action.index);
  if (action.verb == Verb::kPush) keyboard.Press(usage);
  if (action.verb == Verb::kRelease) keyboard.Release(usage);
}

void DoOnPointer(Pointer& pointer, const OperatorAction& action) {
  if (action.verb == Verb::kMove) pointer.Move(action.a, action.b);
  if (action.verb == Verb::kPush) pointer.Push(action.index);
  if (action.verb == Verb::kRelease) pointer.Release(action.index);
  if (action.verb == Verb::kRoll) pointer.Roll(action.a);
}

void DoOnCamera(LipCamera& camera, const OperatorAction& action) {
  if (action.verb == Verb::kLips) camera.SetMouth(action.a, action.b);
  if (action.verb == Verb::kCoverLens) camera.CoverLens(action.index != 0);
  if (action.verb == Verb::kStall) camera.Stall(action.index != 0);
}

void DoOnMicrophone(Microphone& microphone, const OperatorAction& action) {
  if (action.verb == Verb::kVoice) microphone.Say(action.index, action.a);
  if (action.verb == Verb::kStall) microphone.Stall(action.index != 0);
}

void DoOnLines(LinePanel& lines, const OperatorAction& action) {
  if (action.verb == Verb::kPush) lines.Close(action.index);
  if (action.verb == Verb::kRelease) lines.Open(action.index);
}

}  // namespace

InputDevices::InputDevices(const DeviceContext& context, ports::CameraFormat camera_format)
    : dial_box(context),
      left_stick(DevicePort::kStickLeft, context),
      right_stick(DevicePort::kStickRight, context),
      keyboard(context),
      pointer(context),
      camera(camera_format, context),
      microphone(context),
      lines(context) {}

// A port has one device; those without one, such as the screen, have nothing that an operator does.
void InputDevices::Do(const OperatorAction& action) {
  if (action.port == DevicePort::kDialBox) DoOnBox(dial_box, action);
  if (action.port == DevicePort::kStickLeft) DoOnStick(left_stick, action);
  if (action.port == DevicePort::kStickRight) DoOnStick(right_stick, action);
  if (action.port == DevicePort::kKeyboard) DoOnKeyboard(keyboard, action);
  if (action.port == DevicePort::kPointer) DoOnPointer(pointer, action);
  if (action.port == DevicePort::kCamera) DoOnCamera(camera, action);
  if (action.port == DevicePort::kMicrophone) DoOnMicrophone(microphone, action);
  if (action.port == DevicePort::kLines) DoOnLines(lines, action);
}

}  // namespace kaori::sim
