#include "hw-sim/devices/instruments.h"

namespace kaori::sim {
namespace {

void DoOnBox(DialBox& box, const Hand& hand) {
  if (hand.verb == Verb::kTurn) box.Turn(hand.index, hand.a);
  if (hand.verb == Verb::kPush) box.Push(hand.index);
  if (hand.verb == Verb::kRelease) box.Release(hand.index);
}

void DoOnStick(StickPod& stick, const Hand& hand) {
  const auto a = static_cast<float>(hand.a);
  if (hand.verb == Verb::kMove) stick.Move(a, static_cast<float>(hand.b));
  if (hand.verb == Verb::kTwist) stick.Twist(a);
  if (hand.verb == Verb::kSlide) stick.Slide(a);
  if (hand.verb == Verb::kHat) stick.Hat(hand.index);
  if (hand.verb == Verb::kPush) stick.Push(hand.index);
  if (hand.verb == Verb::kRelease) stick.Release(hand.index);
}

void DoOnKeyboard(Keyboard& keyboard, const Hand& hand) {
  if (hand.index < 0 || hand.index > 0xFF) return;
  const auto usage = static_cast<std::uint8_t>(hand.index);
  if (hand.verb == Verb::kPush) keyboard.Press(usage);
  if (hand.verb == Verb::kRelease) keyboard.Release(usage);
}

void DoOnPointer(Pointer& pointer, const Hand& hand) {
  if (hand.verb == Verb::kMove) pointer.Move(hand.a, hand.b);
  if (hand.verb == Verb::kPush) pointer.Push(hand.index);
  if (hand.verb == Verb::kRelease) pointer.Release(hand.index);
  if (hand.verb == Verb::kRoll) pointer.Roll(hand.a);
}

void DoOnCamera(LipCamera& camera, const Hand& hand) {
  if (hand.verb == Verb::kLips) camera.SetMouth(hand.a, hand.b);
  if (hand.verb == Verb::kCoverLens) camera.CoverLens(hand.index != 0);
  if (hand.verb == Verb::kStall) camera.Stall(hand.index != 0);
}

void DoOnMicrophone(Microphone& microphone, const Hand& hand) {
  if (hand.verb == Verb::kVoice) microphone.Say(hand.index, hand.a);
  if (hand.verb == Verb::kStall) microphone.Stall(hand.index != 0);
}

}  // namespace

Instruments::Instruments(const Workbench& bench, ports::CameraFormat camera_format)
    : dial_box(bench),
      left_stick(Place::kStickLeft, bench),
      right_stick(Place::kStickRight, bench),
      keyboard(bench),
      pointer(bench),
      camera(camera_format, bench),
      microphone(bench) {}

void Instruments::Do(const Hand& hand) {
  if (hand.place == Place::kDialBox) DoOnBox(dial_box, hand);
  if (hand.place == Place::kStickLeft) DoOnStick(left_stick, hand);
  if (hand.place == Place::kStickRight) DoOnStick(right_stick, hand);
  if (hand.place == Place::kKeyboard) DoOnKeyboard(keyboard, hand);
  if (hand.place == Place::kPointer) DoOnPointer(pointer, hand);
  if (hand.place == Place::kCamera) DoOnCamera(camera, hand);
  if (hand.place == Place::kMicrophone) DoOnMicrophone(microphone, hand);
}

}  // namespace kaori::sim
