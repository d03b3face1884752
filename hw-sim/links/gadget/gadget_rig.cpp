#include "hw-sim/links/gadget/gadget_rig.h"

namespace kaori::sim {

GadgetRig::GadgetRig(GadgetRoom room, const Clock& clock)
    : room_(std::move(room)),
      bench_{clock, {}},
      instruments_(bench_, {640, 480, ports::PixelFormat::kYuyv}) {}

HidDevice* GadgetRig::DeviceAt(Place place) {
  switch (place) {
    case Place::kDialBox:
      return &instruments_.dial_box;
    case Place::kStickLeft:
      return &instruments_.left_stick;
    case Place::kStickRight:
      return &instruments_.right_stick;
    case Place::kKeyboard:
      return &instruments_.keyboard;
    case Place::kPointer:
      return &instruments_.pointer;
    default:
      return nullptr;
  }
}

Result<void> GadgetRig::Put(Place place, const std::string& controller) {
  HidDevice* const device = DeviceAt(place);
  if (device == nullptr) return FailInput("no HID device stands at " + std::string(PortName(place)));
  auto gadget = HidGadget::Make(room_, "kaori-" + std::string(PortName(place)), device->device_name());
  if (!gadget) return tl::unexpected(gadget.error());
  auto& port = ports_[place];
  port = std::make_unique<GadgetPort>(std::move(*gadget), controller, *device);
  return port->Plug();
}

void GadgetRig::Pump() {
  for (auto& [place, port] : ports_) port->Pump(bench_.clock.now());
}

Result<void> GadgetRig::Do(const Hand& hand) {
  const auto port = ports_.find(hand.place);
  if (hand.verb == Verb::kPlug) return port == ports_.end() ? Result<void>{} : port->second->Plug();
  if (hand.verb == Verb::kUnplug && port != ports_.end()) port->second->Unplug();
  instruments_.Do(hand);
  return {};
}

}  // namespace kaori::sim
