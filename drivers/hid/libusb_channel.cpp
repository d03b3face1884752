#include "drivers/hid/libusb_channel.h"

#include <libusb.h>

#include <algorithm>
#include <utility>

#include "drivers/decode/report_layout.h"

namespace kaori::hid {
namespace {

using ports::HidInput;

// Far more than a device takes for a descriptor, and short enough that a loop of the box survives it.
constexpr unsigned kRequestTimeout_ms = 250;
// A device that does not take a lamp's report within a second has other troubles.
constexpr unsigned kWriteTimeout_ms = 1000;
// HID 1.11, section 7.1: the type of a report descriptor in GET_DESCRIPTOR.
constexpr std::uint8_t kReportDescriptor = 0x22;
constexpr std::uint8_t kSetReport = 0x09;              // HID 1.11, section 7.2.2.
constexpr std::uint16_t kOutputReport = 0x02 << 8;     // High byte of wValue.
constexpr std::uint8_t kClassToInterface = 0x21;       // USB 2.0, table 9-2: out, class, interface.
constexpr std::uint8_t kStandardFromInterface = 0x81;  // In, standard, interface.
constexpr std::uint16_t kEnglish = 0x0409;             // The language that every device with names has.
// Cancelled transfers end within a turn or two; one that never does is freed by libusb's own end.
constexpr int kClosingTurns = 10;
constexpr int kClosingTurn_ms = 10;

// Whole packets for the longest report: a shorter transfer would overflow
// (LIBUSB_TRANSFER_OVERFLOW), a longer one wait for a second report, since only a packet
// that is not full ends a transfer (USB 2.0, section 5.7.3).
std::size_t ReadBytes(std::span<const std::uint8_t> descriptor, std::size_t packet_bytes) {
  std::size_t longest = 1;
  if (const auto layout = decode::ReadReportLayout(descriptor)) {
    const std::size_t id_bytes = layout->numbered(decode::ReportKind::kInput) ? 1 : 0;
    for (const decode::ReportShape& report : layout->reports)
      if (report.kind == decode::ReportKind::kInput) longest = std::max(longest, report.bytes() + id_bytes);
  }
  return packet_bytes * ((longest + packet_bytes - 1) / packet_bytes);
}

}  // namespace

void LibusbChannel::Close::operator()(libusb_device_handle* handle) const {
  libusb_close(handle);
}
void LibusbChannel::FreeTransfer::operator()(libusb_transfer* transfer) const {
  libusb_free_transfer(transfer);
}

// Each channel has a session of its own, whose descriptor wakes its owner for this device alone. Where a step
// fails the destructor gives back what was claimed until then.
Result<std::unique_ptr<LibusbChannel>> LibusbChannel::Open(const std::string& port, const Clock& clock) {
  auto session = LibusbSession::Open();
  if (!session) return tl::unexpected(session.error());
  auto interfaces = (*session)->Interfaces();
  if (!interfaces) return tl::unexpected(interfaces.error());
  const auto it = std::ranges::find(*interfaces, port, &UsbHidInterface::port);
  if (it == interfaces->end()) return Fail(std::errc::no_such_device, "open " + port);
  std::unique_ptr<LibusbChannel> channel(new LibusbChannel(std::move(*session), std::move(*it), clock));
  if (auto ok = channel->Claim(); !ok) return tl::unexpected(ok.error());
  if (auto ok = channel->ReadIdentity(); !ok) return tl::unexpected(ok.error());
  if (auto ok = channel->Prepare(); !ok) return tl::unexpected(ok.error());
  return channel;
}

LibusbChannel::LibusbChannel(std::unique_ptr<LibusbSession> session, UsbHidInterface interface,
                             const Clock& clock)
    : session_(std::move(session)), interface_(std::move(interface)), clock_(clock) {}

LibusbChannel::~LibusbChannel() {
  closing_ = true;
  for (Transfer& transfer : reads_)
    if (transfer.state == Transfer::State::kSubmitted) libusb_cancel_transfer(transfer.handle.get());
  for (Transfer& transfer : writes_)
    if (transfer.state == Transfer::State::kSubmitted) libusb_cancel_transfer(transfer.handle.get());
  for (int turn = 0; turn < kClosingTurns && any_submitted(); ++turn) session_->HandleFor(kClosingTurn_ms);
  if (claimed_) libusb_release_interface(handle_.get(), interface_.number);
}

bool LibusbChannel::any_submitted() const {
  const auto is_submitted = [](const Transfer& transfer) {
    return transfer.state == Transfer::State::kSubmitted;
  };
  return std::ranges::any_of(reads_, is_submitted) || std::ranges::any_of(writes_, is_submitted);
}

Result<void> LibusbChannel::Claim() {
  libusb_device_handle* handle = nullptr;
  if (const int code = libusb_open(interface_.device.get(), &handle); code != 0)
    return FailUsb(code, "open " + interface_.port);
  // The kernel's driver is detached while the interface is claimed, and attached again when it is released.
  handle_.reset(handle);
  libusb_set_auto_detach_kernel_driver(handle, 1);
  if (const int code = libusb_claim_interface(handle, interface_.number); code != 0)
    return FailUsb(code, "claim " + interface_.port);
  claimed_ = true;
  return {};
}

Result<void> LibusbChannel::ReadIdentity() {
  libusb_device_descriptor device{};
  if (const int code = libusb_get_device_descriptor(interface_.device.get(), &device); code != 0)
    return FailUsb(code, "read the device descriptor of " + interface_.port);
  identity_ = {.port = interface_.port,
               .vendor = device.idVendor,
               .product = device.idProduct,
               .name = "",
               .descriptor = {}};
  // A name is for people alone: without one the device works as well.
  if (device.iProduct != 0) identity_.name = ReadName(device.iProduct);
  std::vector<std::uint8_t> descriptor(
      std::min<std::size_t>(interface_.descriptor_bytes, decode::kMaxDescriptorBytes));
  const int bytes = libusb_control_transfer(
      handle_.get(), kStandardFromInterface, LIBUSB_REQUEST_GET_DESCRIPTOR, kReportDescriptor << 8,
      // wIndex is the interface's number, as for every request to an interface (HID 1.11, section 7.1.1).
      static_cast<std::uint16_t>(interface_.number), descriptor.data(),
      static_cast<std::uint16_t>(descriptor.size()), kRequestTimeout_ms);
  if (bytes < 0) return FailUsb(bytes, "read the report descriptor of " + interface_.port);
  descriptor.resize(static_cast<std::size_t>(bytes));
  identity_.descriptor = std::move(descriptor);
  return {};
}

// libusb_get_string_descriptor_ascii would block for two seconds when the device does not answer.
std::string LibusbChannel::ReadName(std::uint8_t index) {
  std::array<std::uint8_t, 255> text{};
  const int bytes =
      libusb_control_transfer(handle_.get(), LIBUSB_ENDPOINT_IN, LIBUSB_REQUEST_GET_DESCRIPTOR,
                              static_cast<std::uint16_t>(LIBUSB_DT_STRING << 8 | index), kEnglish,
                              text.data(), static_cast<std::uint16_t>(text.size()), kRequestTimeout_ms);
  std::string name;
  // Byte 0 of a string descriptor is its length, and byte 1 its type (USB 2.0, section 9.6.7).
  const std::size_t end = std::min<std::size_t>(static_cast<std::size_t>(std::max(bytes, 0)), text[0]);
  for (std::size_t n = 2; n + 1 < end; n += 2)  // UTF-16; what is not ASCII becomes a question mark.
    name += text[n + 1] == 0 && text[n] < 0x80 ? static_cast<char>(text[n]) : '?';
  return name;
}

// All transfers are made here, so that neither Read nor Write allocates one. Several reads are under way at a
// time: while one report is handled the next one has a place to go to.
Result<void> LibusbChannel::Prepare() {
  const auto make = [this](Transfer& transfer, std::size_t bytes) {
    transfer.channel = this;
    transfer.bytes.resize(bytes);
    transfer.handle.reset(libusb_alloc_transfer(0));
    return transfer.handle != nullptr;
  };
  for (Transfer& transfer : writes_)
    if (!make(transfer, 0)) return FailUsb(LIBUSB_ERROR_NO_MEM, "write to " + interface_.port);
  for (Transfer& transfer : reads_) {
    if (!make(transfer, ReadBytes(identity_.descriptor, interface_.in_packet_bytes)))
      return FailUsb(LIBUSB_ERROR_NO_MEM, "read " + interface_.port);
    if (auto ok = AwaitInput(transfer); !ok) return ok;
  }
  return {};
}

Result<void> LibusbChannel::AwaitInput(Transfer& transfer) {
  // libusb's time-out of 0: the transfer waits until the device has a report.
  constexpr unsigned kForEver = 0;
  libusb_fill_interrupt_transfer(transfer.handle.get(), handle_.get(), interface_.in_endpoint,
                                 transfer.bytes.data(), static_cast<int>(transfer.bytes.size()), OnDone,
                                 &transfer, kForEver);
  return Submit(transfer);
}

Result<void> LibusbChannel::Submit(Transfer& transfer) {
  transfer.state = Transfer::State::kIdle;
  const int code = libusb_submit_transfer(transfer.handle.get());
  // The refusal may come before libusb notices by itself that the device is gone.
  if (code == LIBUSB_ERROR_NO_DEVICE) gone_ = true;
  if (code != 0) return FailUsb(code, "start a transfer of " + interface_.port);
  transfer.state = Transfer::State::kSubmitted;
  return {};
}

void LibusbChannel::OnDone(libusb_transfer* done) {
  auto& transfer = *static_cast<Transfer*>(done->user_data);
  transfer.channel->HandleDone(transfer);
}

void LibusbChannel::HandleDone(Transfer& transfer) {
  transfer.state = Transfer::State::kIdle;
  // Cancelled transfers end here while the channel closes.
  if (closing_) return;
  const libusb_transfer& done = *transfer.handle;
  const bool is_read = done.endpoint == interface_.in_endpoint;
  if (done.status == LIBUSB_TRANSFER_NO_DEVICE) gone_ = true;
  if (done.status == LIBUSB_TRANSFER_COMPLETED && is_read && done.actual_length > 0) {
    transfer.state = Transfer::State::kCompleted;
    transfer.at = clock_.now();
    transfer.order = ++arrivals_;
  } else if (done.status != LIBUSB_TRANSFER_COMPLETED) {
    broken_ = true;
  }
  session_->SetReadable(true);  // Read tells of the report, or of the device's end.
}

LibusbChannel::Transfer* LibusbChannel::Oldest() {
  Transfer* oldest = nullptr;
  for (Transfer& transfer : reads_)
    if (transfer.state == Transfer::State::kCompleted &&
        (oldest == nullptr || transfer.order < oldest->order))
      oldest = &transfer;
  return oldest;
}

Result<HidInput> LibusbChannel::Read(std::span<std::uint8_t> into) {
  // Call-backs that are due run now, and complete transfers.
  if (auto ok = session_->Handle(); !ok) return tl::unexpected(ok.error());
  if (Transfer* transfer = Oldest()) {
    const auto bytes = std::min(into.size(), static_cast<std::size_t>(transfer->handle->actual_length));
    std::copy_n(transfer->bytes.begin(), bytes, into.begin());
    const HidInput input{.at = transfer->at, .bytes = bytes};
    transfer->state = Transfer::State::kIdle;
    if (!gone_)
      static_cast<void>(AwaitInput(*transfer));  // A failure is told below, once nothing is left to read.
    return input;
  }
  if (gone_) return Gone();
  // Nothing is left to read; from here on USB alone makes the descriptor readable.
  session_->SetReadable(false);
  // A transfer whose submission failed earlier is tried again here, so
  // that one error does not silence the device.
  for (Transfer& transfer : reads_)
    if (transfer.state == Transfer::State::kIdle && !AwaitInput(transfer)) broken_ = true;
  if (gone_) return Gone();
  if (std::exchange(broken_, false)) return Fail(std::errc::io_error, "read " + interface_.port);
  return Fail(std::errc::resource_unavailable_try_again, "read " + interface_.port);
}

Result<void> LibusbChannel::Write(std::span<const std::uint8_t> report) {
  if (report.empty()) return FailInput("write an empty report to " + interface_.port);
  if (auto ok = session_->Handle(); !ok) return ok;
  if (gone_) return Gone();
  const auto idle = std::ranges::find(writes_, Transfer::State::kIdle, &Transfer::state);
  if (idle == writes_.end())
    return Fail(std::errc::resource_unavailable_try_again, "write to " + interface_.port);
  FillWrite(*idle, report);
  return Submit(*idle);
}

// A report id of 0 stands for none and is not sent. Without an OUT endpoint the report goes as SET_REPORT.
void LibusbChannel::FillWrite(Transfer& transfer, std::span<const std::uint8_t> report) {
  const std::uint8_t id = report[0];
  const auto payload = report.subspan(id == 0 ? 1 : 0);
  const bool by_control = interface_.out_endpoint == 0;
  transfer.bytes.assign(by_control ? LIBUSB_CONTROL_SETUP_SIZE : 0, 0);
  if (by_control)
    libusb_fill_control_setup(
        transfer.bytes.data(), kClassToInterface, kSetReport, static_cast<std::uint16_t>(kOutputReport | id),
        static_cast<std::uint16_t>(interface_.number), static_cast<std::uint16_t>(payload.size()));
  transfer.bytes.insert(transfer.bytes.end(), payload.begin(), payload.end());
  if (by_control)
    libusb_fill_control_transfer(transfer.handle.get(), handle_.get(), transfer.bytes.data(), OnDone,
                                 &transfer, kWriteTimeout_ms);
  else
    libusb_fill_interrupt_transfer(transfer.handle.get(), handle_.get(), interface_.out_endpoint,
                                   transfer.bytes.data(), static_cast<int>(transfer.bytes.size()), OnDone,
                                   &transfer, kWriteTimeout_ms);
}

tl::unexpected<Error> LibusbChannel::Gone() const {
  return Fail(std::errc::no_such_device, "use " + interface_.port);
}

}  // namespace kaori::hid
