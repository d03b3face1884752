#include "firmware/board/rp2040/usb_controller.h"

#include <algorithm>
#include <array>

#include "firmware/board/rp2040/chip.h"
#include "firmware/board/rp2040/registers.h"

namespace kaori::rp2040 {
namespace {

// Places in the controller's memory (4.1.2.5.2): a control word for each endpoint but 0, a buffer word for
// each, buffers.
constexpr std::uint32_t kInputControl = kUsbMemory + 0x08, kOutputControl = kUsbMemory + 0x0C;
constexpr std::uint32_t kControlInBuffer = kUsbMemory + 0x80, kControlOutBuffer = kUsbMemory + 0x84;
constexpr std::uint32_t kInputBuffer = kUsbMemory + 0x88, kOutputBuffer = kUsbMemory + 0x8C;
constexpr std::uint32_t kControlData = 0x100, kInputData = 0x180,
                        kOutputData = 0x1C0;  // From the memory's beginning.
constexpr std::uint32_t kMemoryBytes = 4096;

// A buffer word (4.1.2.5.4).
constexpr std::uint32_t kFull = 1U << 15, kLast = 1U << 14, kOdd = 1U << 13, kStall = 1U << 11,
                        kAvailable = 1U << 10, kLengthMask = 0x3FF;
// An endpoint's control word: enabled, told after each buffer, interrupt transfers.
constexpr std::uint32_t kInterruptEndpoint = 1U << 31 | 1U << 29 | 3U << 26;
// Bits of the status registers.
constexpr std::uint32_t kBusReset = 1U << 19, kSetupReceived = 1U << 17, kResumed = 1U << 11,
                        kSuspended = 1U << 4;
constexpr std::uint32_t kControlSent = 1U << 0, kControlReceived = 1U << 1, kInputSent = 1U << 2,
                        kOutputReceived = 1U << 3;
constexpr std::uint32_t kToPhy = 1U << 0, kSoftConnect = 1U << 3;
// The cable's voltage is not wired to a pin: it is there, or there would be no power.
constexpr std::uint32_t kVoltageIsThere = 1U << 2 | 1U << 3;
constexpr std::uint32_t kControllerEnable = 1U << 0;
constexpr std::uint32_t kTellEachControlBuffer = 1U << 29, kPullUp = 1U << 16;

std::uint8_t* Data(std::uint32_t place) {
  return reinterpret_cast<std::uint8_t*>(kUsbMemory + place);
}

// The controller runs on another clock: the bit that hands the buffer over comes some cycles after all others
// (4.1.2.5.1).
void HandOver(std::uint32_t buffer, std::uint32_t word) {
  At(buffer) = word;
  for (int n = 0; n < 12; ++n) asm volatile("nop");
  At(buffer) = word | kAvailable;
}

// Packets of one endpoint are even and odd in turn (DATA0, DATA1): a host that sees the same twice knows that
// its answer was lost.
void Send(std::uint32_t buffer, std::uint32_t place, std::span<const std::uint8_t> packet, bool& odd) {
  volatile std::uint8_t* to = Data(place);
  for (std::size_t n = 0; n < packet.size(); ++n) to[n] = packet[n];
  HandOver(buffer, static_cast<std::uint32_t>(packet.size()) | kFull | kLast | (odd ? kOdd : 0));
  odd = !odd;
}

// Lets the host send one packet. Until then it is told to wait (NAK) by the controller itself.
void Receive(std::uint32_t buffer, bool& odd) {
  HandOver(buffer, static_cast<std::uint32_t>(surface::kPacketBytes) | kLast | (odd ? kOdd : 0));
  odd = !odd;
}

// What a host sent, copied off the controller's memory.
std::span<const std::uint8_t> Received(std::uint32_t buffer, std::uint32_t place,
                                       std::array<std::uint8_t, surface::kPacketBytes>& into) {
  const std::size_t bytes = std::min<std::size_t>(At(buffer) & kLengthMask, into.size());
  const volatile std::uint8_t* from = Data(place);
  for (std::size_t n = 0; n < bytes; ++n) into[n] = from[n];
  return std::span(into).first(bytes);
}

}  // namespace

// The memory is not cleared by a reset, and an old buffer word would send an old report. The pull-up comes
// last: from then on the host sees a device.
void UsbController::Start() {
  Release(kResetUsb);
  for (std::uint32_t place = 0; place < kMemoryBytes; place += 4) At(kUsbMemory + place) = 0;
  At(kUsbMuxing) = kToPhy | kSoftConnect;
  At(kUsbPower) = kVoltageIsThere;
  At(kUsbMain) = kControllerEnable;
  At(kUsbSieControl) = kTellEachControlBuffer | kPullUp;
}

// From the main loop, at each look; nothing in it waits. A status bit is cleared by writing it back, and
// before the device is told: what comes while it answers sets the bit again and is found at the next look.
void UsbController::Service(surface::UsbDevice& device) {
  const std::uint32_t status = At(kUsbSieStatus);
  if ((status & kBusReset) != 0) {
    At(kUsbSieStatus) = kBusReset;
    device.HandleReset();
  }
  if ((status & kSuspended) != 0) {
    At(kUsbSieStatus) = kSuspended;
    device.HandleSuspend();
  }
  if ((status & kResumed) != 0) {
    At(kUsbSieStatus) = kResumed;
    device.HandleResume();
  }
  // What ended before a SETUP came is told before it.
  ServiceBuffers(device);
  if ((status & kSetupReceived) != 0) {
    At(kUsbSieStatus) = kSetupReceived;
    std::array<std::uint8_t, 8> setup;
    const volatile std::uint8_t* from = Data(0);
    for (std::size_t n = 0; n < setup.size(); ++n) setup[n] = from[n];
    device.HandleSetup(setup);
  }
}

// A bit stands for one buffer that the host has fetched or filled. All bits that were read are cleared at
// once; one that is set meanwhile stays for the next look.
void UsbController::ServiceBuffers(surface::UsbDevice& device) {
  const std::uint32_t done = At(kUsbBufferStatus);
  if (done == 0) return;
  At(kUsbBufferStatus) = done;
  std::array<std::uint8_t, surface::kPacketBytes> packet;
  if ((done & kControlSent) != 0) device.HandleControlSent();
  if ((done & kControlReceived) != 0)
    device.HandleControlReceived(Received(kControlOutBuffer, kControlData, packet));
  if ((done & kInputSent) != 0) input_free_ = true;
  if ((done & kOutputReceived) != 0) {
    device.HandleOutput(Received(kOutputBuffer, kOutputData, packet));
    ArmOutput();
  }
}

void UsbController::CancelControl() {
  At(kControlInBuffer) = 0;
  At(kControlOutBuffer) = 0;
  At(kUsbBufferStatus) = kControlSent | kControlReceived;
  control_in_odd_ = control_out_odd_ = true;
}

void UsbController::SendControl(std::span<const std::uint8_t> packet) {
  Send(kControlInBuffer, kControlData, packet, control_in_odd_);
}

void UsbController::ReceiveControl() {
  Receive(kControlOutBuffer, control_out_odd_);
}

// Both words want the bit, and endpoint 0 wants to be armed for it besides; a SETUP disarms it (4.1.2.5.4).
void UsbController::StallControl() {
  At(kUsbStallArm) = kControlSent | kControlReceived;
  At(kControlInBuffer) = kStall;
  At(kControlOutBuffer) = kStall;
}

void UsbController::SetAddress(std::uint8_t address) {
  At(kUsbAddress) = address;
}

// Both data toggles begin at DATA0 when a configuration is set (USB 2.0, 9.1.1.5).
void UsbController::OpenEndpoints() {
  At(kInputControl) = kInterruptEndpoint | kInputData;
  At(kOutputControl) = kInterruptEndpoint | kOutputData;
  input_odd_ = output_odd_ = false;
  input_free_ = true;
  ArmOutput();
}

// Bits of buffers that ended just before are cleared too: they would be told of a later configuration.
void UsbController::CloseEndpoints() {
  At(kInputControl) = 0;
  At(kOutputControl) = 0;
  At(kInputBuffer) = 0;
  At(kOutputBuffer) = 0;
  At(kUsbBufferStatus) = kInputSent | kOutputReceived;
  input_free_ = true;
}

// A halt that is cleared begins at DATA0 again, whatever the toggle was (USB 2.0, 9.4.5). A report that
// waited in the input buffer is lost with it.
void UsbController::SetHalt(std::uint8_t endpoint, bool halted) {
  if (endpoint == surface::kInputEndpoint) {
    At(kInputBuffer) = halted ? kStall : 0;
    input_odd_ = false;
    input_free_ = true;
  } else if (halted) {
    At(kOutputBuffer) = kStall;
  } else {
    output_odd_ = false;
    ArmOutput();
  }
}

void UsbController::SendInput(std::span<const std::uint8_t> report) {
  input_free_ = false;
  Send(kInputBuffer, kInputData, report, input_odd_);
}

void UsbController::ArmOutput() {
  Receive(kOutputBuffer, output_odd_);
}

}  // namespace kaori::rp2040
