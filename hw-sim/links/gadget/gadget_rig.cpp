#include "hw-sim/links/gadget/gadget_rig.h"

namespace kaori::sim {

// InputDevices has a camera, which is at no controller here: its format counts for nothing.
GadgetRig::GadgetRig(GadgetRoom room, const Clock& clock)
    : room_(std::move(room)),
      context_{clock, {}},
      devices_(context_, {640, 480, ports::PixelFormat::kYuyv}) {}

HidDevice* GadgetRig::DeviceAt(DevicePort port) {
  switch (port) {
    case DevicePort::kDialBox:
      return &devices_.dial_box;
    case DevicePort::kStickLeft:
      return &devices_.left_stick;
    case DevicePort::kStickRight:
      return &devices_.right_stick;
    case DevicePort::kKeyboard:
      return &devices_.keyboard;
    case DevicePort::kPointer:
      return &devices_.pointer;
    default:
      return nullptr;
  }
}

Result<void> GadgetRig::Put(DevicePort port, const std::string& controller) {
  HidDevice* const device = DeviceAt(port);
  if (device == nullptr) return FailInput("no HID device is at the port " + std::string(PortName(port)));
  // The name of the gadget tells whose it is, in configfs and in the kernel's log.
  auto gadget = HidGadget::Make(room_, "kaori-" + std::string(PortName(port)), device->device_name());
  if (!gadget) return tl::unexpected(gadget.error());
  auto& gadget_port = ports_[port];
  // Where plugging in fails the port stays: `plug` of the scenario tries again.
  gadget_port = std::make_unique<GadgetPort>(std::move(*gadget), controller, *device);
  return gadget_port->Plug();
}

// A port whose cable is out does nothing.
void GadgetRig::Pump() {
  for (auto& [name, port] : ports_) port->Pump(context_.clock.now());
}

Result<void> GadgetRig::Do(const OperatorAction& action) {
  const auto port = ports_.find(action.port);
  if (action.verb == Verb::kPlug) return port == ports_.end() ? Result<void>{} : port->second->Plug();
  if (action.verb == Verb::kUnplug && port != ports_.end()) port->second->Unplug();
  devices_.Do(action);
  return {};
}

}  // namespace kaori::sim
