#include "firmware/surface/usb_device.h"

#include <algorithm>

#include "firmware/wire/bytes.h"

namespace kaori::surface {
namespace {

// bmRequestType (USB 2.0, table 9-2).
constexpr std::uint8_t kToHost = 0x80;
constexpr std::uint8_t kDevice = 0x00, kInterface = 0x01, kEndpoint = 0x02, kHidInterface = 0x21;
// bRequest (table 9-4; HID 1.11, 7.2).
constexpr std::uint8_t kGetStatus = 0, kClearFeature = 1, kSetFeature = 3, kSetAddress = 5,
                       kGetDescriptor = 6;
constexpr std::uint8_t kGetConfiguration = 8, kSetConfiguration = 9, kGetInterface = 10, kSetInterface = 11;
constexpr std::uint8_t kGetReport = 1, kGetIdle = 2, kSetReport = 9, kSetIdle = 10;
// The one feature of an endpoint that a host may switch (USB 2.0, table 9-6).
constexpr std::uint16_t kEndpointHalt = 0;
constexpr std::uint8_t kOurConfiguration = 1;
constexpr std::uint16_t kMostAddress = 127;

// wValue of descriptors and reports carries two numbers: the type in its high byte, the index in its low one
// (USB 2.0, 9.4.3; HID 1.11, 7.2.1).
std::uint8_t High(std::uint16_t value) {
  return static_cast<std::uint8_t>(value >> 8);
}
std::uint8_t Low(std::uint16_t value) {
  return static_cast<std::uint8_t>(value & 0xFF);
}
// Of a host's word a ReportKind is made only after this.
bool IsReportKind(std::uint8_t kind) {
  return kind >= 1 && kind <= 3;
}

}  // namespace

// A reset of the bus: the device is back in its default state (USB 2.0, 9.1.1.3), without an address and a
// configuration. What a transfer was about to say is forgotten, for its host may be another one.
void UsbDevice::HandleReset() {
  port_.CancelControl();
  port_.CloseEndpoints();
  port_.SetAddress(0);
  stage_ = Stage::kSetup;
  new_address_ = 0;
  configuration_ = 0;
  suspended_ = false;
  input_halted_ = output_halted_ = false;
  TellHost();
}

// The bus was silent for 3 ms. Configuration and address stay (9.1.1.6); the lamps go dark, for a suspended
// device may draw next to nothing.
void UsbDevice::HandleSuspend() {
  suspended_ = true;
  TellHost();
}

void UsbDevice::HandleResume() {
  suspended_ = false;
  TellHost();
}

// The surface only wants to know whether anybody listens; USB's six states become three.
void UsbDevice::TellHost() {
  function_.SetHost(configuration_ == 0 ? Host::kGone : suspended_ ? Host::kAsleep : Host::kThere);
}

// The beginning of a control transfer: bmRequestType, bRequest, wValue, wIndex, wLength (USB 2.0, 9.3). A
// host may begin one at any time, also in the middle of another.
void UsbDevice::HandleSetup(std::span<const std::uint8_t, 8> packet) {
  // Whatever the transfer before has armed would be taken for the answer to this one.
  port_.CancelControl();
  setup_ = {packet[0], packet[1], wire::GetU16(packet, 2), wire::GetU16(packet, 4), wire::GetU16(packet, 6)};
  new_address_ = 0;
  received_ = 0;
  if ((setup_.type & kToHost) != 0) {
    if (!Answer()) return Finish(false);
    // A host that wants no byte of the answer gets a transfer without data, whose status goes its way
    // (8.5.3).
    if (setup_.length == 0) return Finish(true);
    ends_short_ = answer_.size() < setup_.length;
    answer_ = answer_.first(std::min<std::size_t>(answer_.size(), setup_.length));
    stage_ = Stage::kDataIn;
    return SendNext();
  }
  if (setup_.length == 0) return Finish(Do());
  // The one request with data from the host.
  const bool is_report = setup_.type == kHidInterface && setup_.request == kSetReport;
  if (!is_report || setup_.length > buffer_.size()) return Finish(false);
  stage_ = Stage::kDataOut;
  port_.ReceiveControl();
}

// The end of a transfer without an answer.
void UsbDevice::Finish(bool accepted) {
  stage_ = accepted ? Stage::kStatusIn : Stage::kSetup;
  if (accepted) {
    port_.SendControl({});
  } else {
    port_.StallControl();
  }
}

// The next packet of the answer. An answer that is shorter than the host wanted and fills its last packet is
// followed by an empty one, or the host would wait for more (8.5.3.2).
void UsbDevice::SendNext() {
  const auto packet = answer_.first(std::min(answer_.size(), kPacketBytes));
  answer_ = answer_.subspan(packet.size());
  // A packet that is not full ends the data.
  if (packet.size() < kPacketBytes) ends_short_ = false;
  port_.SendControl(packet);
}

// The host has fetched what was armed. The address counts only from the end of the status stage on (9.4.6):
// before, the host still speaks to address 0.
void UsbDevice::HandleControlSent() {
  if (stage_ == Stage::kDataIn) {
    if (!answer_.empty() || ends_short_) return SendNext();
    stage_ = Stage::kStatusOut;
    return port_.ReceiveControl();
  }
  if (stage_ != Stage::kStatusIn) return;
  stage_ = Stage::kSetup;
  if (new_address_ != 0) port_.SetAddress(new_address_);
}

// Data of the host, or the empty packet of its status stage. More than was announced is refused and not
// written: the buffer has no room beyond.
void UsbDevice::HandleControlReceived(std::span<const std::uint8_t> packet) {
  if (stage_ == Stage::kStatusOut) stage_ = Stage::kSetup;
  if (stage_ != Stage::kDataOut) return;
  if (packet.size() > setup_.length - received_) return Finish(false);
  std::ranges::copy(packet, buffer_.begin() + static_cast<std::ptrdiff_t>(received_));
  received_ += packet.size();
  if (received_ == setup_.length) return Finish(Do());
  // Less came than was announced.
  if (packet.size() < kPacketBytes) return Finish(false);
  port_.ReceiveControl();
}

// For answers of a byte or two, which need memory that lasts until they are fetched.
bool UsbDevice::AnswerBytes(std::initializer_list<std::uint8_t> bytes) {
  std::ranges::copy(bytes, buffer_.begin());
  answer_ = std::span(buffer_).first(bytes.size());
  return true;
}

// Requests to the host, by whom they ask: device, interface, endpoint, HID. False stalls the transfer, which
// is how a device says that it does not know a request (9.2.7).
bool UsbDevice::Answer() {
  switch (setup_.type & ~kToHost) {
    case kDevice:
      return AnswerDevice();
    case kInterface:
      return AnswerInterface();
    case kEndpoint:
      return AnswerEndpoint();
    case kHidInterface:
      if (!configured() || setup_.index != 0) return false;
      // An idle rate of 0: reports leave on change only.
      if (setup_.request == kGetIdle) return AnswerBytes({0});
      // Reports have no numbers.
      if (setup_.request != kGetReport || Low(setup_.value) != 0 || !IsReportKind(High(setup_.value)))
        return false;
      answer_ =
          std::span(buffer_).first(function_.Answer(static_cast<ReportKind>(High(setup_.value)), buffer_));
      return !answer_.empty();
    default:
      return false;
  }
}

bool UsbDevice::AnswerDevice() {
  // Bus powered, no remote wakeup.
  if (setup_.request == kGetStatus) return AnswerBytes({0, 0});
  if (setup_.request == kGetConfiguration) return AnswerBytes({configuration_});
  return setup_.request == kGetDescriptor && AnswerDescriptor();
}

// Requests to an interface: there is one, number 0. False refuses them.
bool UsbDevice::AnswerInterface() {
  if (setup_.index != 0) return false;
  // Linux asks for HID's descriptors before anything else, but after the configuration (7.1.1).
  if (setup_.request == kGetDescriptor) return AnswerDescriptor();
  if (!configured()) return false;
  if (setup_.request == kGetStatus) return AnswerBytes({0, 0});
  return setup_.request == kGetInterface && AnswerBytes({0});
}

bool UsbDevice::AnswerEndpoint() {
  if (setup_.request != kGetStatus) return false;
  if ((setup_.index & 0x7F) == 0) return AnswerBytes({0, 0});
  if (!is_endpoint(setup_.index)) return false;
  return AnswerBytes({static_cast<std::uint8_t>(halt(setup_.index) ? 1 : 0), 0});
}

// Device and configuration descriptors are asked of the device, HID's own of the interface (HID 1.11, 7.1.1);
// the other way round neither is given. The report descriptor is sent from where it lies.
bool UsbDevice::AnswerDescriptor() {
  const auto type = static_cast<DescriptorType>(High(setup_.value));
  const bool of_interface = (setup_.type & 0x1F) == kInterface;
  const bool is_hid = type == DescriptorType::kHid || type == DescriptorType::kReport;
  if (of_interface != is_hid) return false;
  if (type == DescriptorType::kReport) {
    answer_ = identity_.report_descriptor;
    return Low(setup_.value) == 0;
  }
  answer_ = std::span(buffer_).first(WriteDescriptor(identity_, type, Low(setup_.value), buffer_));
  return !answer_.empty();
}

// Requests without an answer. What only a configured device has is refused before that (9.4).
bool UsbDevice::Do() {
  switch (setup_.type) {
    case kDevice:
      // No feature of the device can be switched: it wakes nobody.
      if (setup_.request == kSetConfiguration) return SetConfiguration(setup_.value);
      if (setup_.request != kSetAddress || setup_.value > kMostAddress) return false;
      new_address_ = static_cast<std::uint8_t>(setup_.value);
      return true;
    case kInterface:
      return configured() && setup_.index == 0 && setup_.request == kSetInterface && setup_.value == 0;
    case kEndpoint:
      return DoForEndpoint();
    case kHidInterface:
      if (!configured() || setup_.index != 0) return false;
      // Other idle rates would have reports come without a change: that is refused (7.2.4 leaves it to the
      // device).
      if (setup_.request == kSetIdle) return High(setup_.value) == 0;
      if (setup_.request != kSetReport || Low(setup_.value) != 0 || !IsReportKind(High(setup_.value)))
        return false;
      return function_.Accept(static_cast<ReportKind>(High(setup_.value)),
                              std::span(buffer_).first(received_));
    default:
      return false;
  }
}

// The endpoints beside 0, which there are only while the device is configured.
bool UsbDevice::is_endpoint(std::uint16_t index) const {
  return configured() && (index == kInputEndpoint || (index == kOutputEndpoint && identity_.takes_output));
}

// Endpoint 0 has no halt that lasts; to end it is allowed.
bool UsbDevice::DoForEndpoint() {
  if (setup_.value != kEndpointHalt) return false;
  if (setup_.request != kClearFeature && setup_.request != kSetFeature) return false;
  const bool halted = setup_.request == kSetFeature;
  if ((setup_.index & 0x7F) == 0) return !halted;
  if (!is_endpoint(setup_.index)) return false;
  halt(setup_.index) = halted;
  port_.SetHalt(static_cast<std::uint8_t>(setup_.index), halted);
  return true;
}

// Also the one that is set already begins anew: data toggles start at 0 and halts end (9.1.1.5).
bool UsbDevice::SetConfiguration(std::uint16_t value) {
  if (value != 0 && value != kOurConfiguration) return false;
  port_.CloseEndpoints();
  input_halted_ = output_halted_ = false;
  configuration_ = static_cast<std::uint8_t>(value);
  if (configured()) port_.OpenEndpoints();
  TellHost();
  return true;
}

// An input report is made only when the endpoint is free for it, so that what the host fetches is as new as
// it can be: reports do not queue behind each other.
void UsbDevice::Poll() {
  if (!configured() || suspended_ || input_halted_ || !port_.IsInputFree()) return;
  std::array<std::uint8_t, kPacketBytes> report;
  const std::size_t bytes = function_.NextInput(report);
  if (bytes != 0) port_.SendInput(std::span(report).first(bytes));
}

}  // namespace kaori::surface
