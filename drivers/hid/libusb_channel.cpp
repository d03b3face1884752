#include "drivers/hid/libusb_channel.h"

#include <libusb.h>

#include <algorithm>
#include <utility>

#include "drivers/decode/report_layout.h"

namespace kaori::hid {
namespace {

using ports::HidInput;

constexpr unsigned kAskTimeout_ms = 250;
constexpr unsigned kWriteTimeout_ms = 1000;
constexpr std::uint8_t kReportDescriptor = 0x22;
constexpr std::uint8_t kSetReport = 0x09;              // HID 1.11, section 7.2.2.
constexpr std::uint16_t kOutputReport = 0x02 << 8;     // High byte of wValue.
constexpr std::uint8_t kClassToInterface = 0x21;       // USB 2.0, table 9-2: out, class, interface.
constexpr std::uint8_t kStandardFromInterface = 0x81;  // In, standard, interface.
constexpr std::uint16_t kEnglish = 0x0409;             // The language that every device with names has.
constexpr int kEndingTurns = 10;
constexpr int kEndingTurn_ms = 10;

// Whole packets for the longest report: a shorter transfer overflows, a longer one waits for a second report.
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
  for (Flight& flight : reads_)
    if (flight.state == Flight::State::kUnderWay) libusb_cancel_transfer(flight.transfer.get());
  for (Flight& flight : writes_)
    if (flight.state == Flight::State::kUnderWay) libusb_cancel_transfer(flight.transfer.get());
  for (int turn = 0; turn < kEndingTurns && any_under_way(); ++turn) session_->HandleFor(kEndingTurn_ms);
  if (claimed_) libusb_release_interface(handle_.get(), interface_.number);
}

bool LibusbChannel::any_under_way() const {
  const auto under_way = [](const Flight& flight) { return flight.state == Flight::State::kUnderWay; };
  return std::ranges::any_of(reads_, under_way) || std::ranges::any_of(writes_, under_way);
}

Result<void> LibusbChannel::Claim() {
  libusb_device_handle* handle = nullptr;
  if (const int code = libusb_open(interface_.device.get(), &handle); code != 0)
    return FailUsb(code, "open " + interface_.port);
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
  if (device.iProduct != 0) identity_.name = ReadName(device.iProduct);
  std::vector<std::uint8_t> descriptor(
      std::min<std::size_t>(interface_.descriptor_bytes, decode::kMaxDescriptorBytes));
  const int bytes = libusb_control_transfer(handle_.get(), kStandardFromInterface,
                                            LIBUSB_REQUEST_GET_DESCRIPTOR, kReportDescriptor << 8,
                                            static_cast<std::uint16_t>(interface_.number), descriptor.data(),
                                            static_cast<std::uint16_t>(descriptor.size()), kAskTimeout_ms);
  if (bytes < 0) return FailUsb(bytes, "read the report descriptor of " + interface_.port);
  descriptor.resize(static_cast<std::size_t>(bytes));
  identity_.descriptor = std::move(descriptor);
  return {};
}

// libusb's own question for a name waits up to two seconds for a device that does not answer.
std::string LibusbChannel::ReadName(std::uint8_t index) {
  std::array<std::uint8_t, 255> text{};
  const int bytes =
      libusb_control_transfer(handle_.get(), LIBUSB_ENDPOINT_IN, LIBUSB_REQUEST_GET_DESCRIPTOR,
                              static_cast<std::uint16_t>(LIBUSB_DT_STRING << 8 | index), kEnglish,
                              text.data(), static_cast<std::uint16_t>(text.size()), kAskTimeout_ms);
  std::string name;
  const std::size_t end = std::min<std::size_t>(static_cast<std::size_t>(std::max(bytes, 0)), text[0]);
  for (std::size_t n = 2; n + 1 < end; n += 2)  // UTF-16, of which we take what is ASCII.
    name += text[n + 1] == 0 && text[n] < 0x80 ? static_cast<char>(text[n]) : '?';
  return name;
}

Result<void> LibusbChannel::Prepare() {
  const auto make = [this](Flight& flight, std::size_t bytes) {
    flight.channel = this;
    flight.bytes.resize(bytes);
    flight.transfer.reset(libusb_alloc_transfer(0));
    return flight.transfer != nullptr;
  };
  for (Flight& flight : writes_)
    if (!make(flight, 0)) return FailUsb(LIBUSB_ERROR_NO_MEM, "write to " + interface_.port);
  for (Flight& flight : reads_) {
    if (!make(flight, ReadBytes(identity_.descriptor, interface_.in_packet_bytes)))
      return FailUsb(LIBUSB_ERROR_NO_MEM, "read " + interface_.port);
    if (auto ok = AwaitInput(flight); !ok) return ok;
  }
  return {};
}

Result<void> LibusbChannel::AwaitInput(Flight& flight) {
  constexpr unsigned kForEver = 0;
  libusb_fill_interrupt_transfer(flight.transfer.get(), handle_.get(), interface_.in_endpoint,
                                 flight.bytes.data(), static_cast<int>(flight.bytes.size()), OnDone, &flight,
                                 kForEver);
  return Submit(flight);
}

Result<void> LibusbChannel::Submit(Flight& flight) {
  flight.state = Flight::State::kIdle;
  const int code = libusb_submit_transfer(flight.transfer.get());
  if (code == LIBUSB_ERROR_NO_DEVICE) gone_ = true;
  if (code != 0) return FailUsb(code, "start a transfer of " + interface_.port);
  flight.state = Flight::State::kUnderWay;
  return {};
}

void LibusbChannel::OnDone(libusb_transfer* transfer) {
  auto& flight = *static_cast<Flight*>(transfer->user_data);
  flight.channel->Landed(flight);
}

void LibusbChannel::Landed(Flight& flight) {
  flight.state = Flight::State::kIdle;
  if (closing_) return;
  const libusb_transfer& transfer = *flight.transfer;
  const bool is_read = transfer.endpoint == interface_.in_endpoint;
  if (transfer.status == LIBUSB_TRANSFER_NO_DEVICE) gone_ = true;
  if (transfer.status == LIBUSB_TRANSFER_COMPLETED && is_read && transfer.actual_length > 0) {
    flight.state = Flight::State::kArrived;
    flight.at = clock_.now();
    flight.order = ++arrivals_;
  } else if (transfer.status != LIBUSB_TRANSFER_COMPLETED) {
    broken_ = true;
  }
  session_->ShowWaiting(true);  // A report, or news of the device's end: Read is to look.
}

LibusbChannel::Flight* LibusbChannel::Oldest() {
  Flight* oldest = nullptr;
  for (Flight& flight : reads_)
    if (flight.state == Flight::State::kArrived && (oldest == nullptr || flight.order < oldest->order))
      oldest = &flight;
  return oldest;
}

Result<HidInput> LibusbChannel::Read(std::span<std::uint8_t> into) {
  if (auto ok = session_->Handle(); !ok) return tl::unexpected(ok.error());
  if (Flight* flight = Oldest()) {
    const auto bytes = std::min(into.size(), static_cast<std::size_t>(flight->transfer->actual_length));
    std::copy_n(flight->bytes.begin(), bytes, into.begin());
    const HidInput input{.at = flight->at, .bytes = bytes};
    flight->state = Flight::State::kIdle;
    if (!gone_)
      static_cast<void>(AwaitInput(*flight));  // A refusal shows below, when nothing is left to read.
    return input;
  }
  if (gone_) return Gone();
  session_->ShowWaiting(false);
  for (Flight& flight : reads_)
    if (flight.state == Flight::State::kIdle && !AwaitInput(flight)) broken_ = true;
  if (gone_) return Gone();
  if (std::exchange(broken_, false)) return Fail(std::errc::io_error, "read " + interface_.port);
  return Fail(std::errc::resource_unavailable_try_again, "read " + interface_.port);
}

Result<void> LibusbChannel::Write(std::span<const std::uint8_t> report) {
  if (report.empty()) return FailInput("write an empty report to " + interface_.port);
  if (auto ok = session_->Handle(); !ok) return ok;
  if (gone_) return Gone();
  const auto idle = std::ranges::find(writes_, Flight::State::kIdle, &Flight::state);
  if (idle == writes_.end())
    return Fail(std::errc::resource_unavailable_try_again, "write to " + interface_.port);
  FillWrite(*idle, report);
  return Submit(*idle);
}

// A report id of 0 stands for none and does not travel. Without an OUT endpoint the report goes as
// SET_REPORT.
void LibusbChannel::FillWrite(Flight& flight, std::span<const std::uint8_t> report) {
  const std::uint8_t id = report[0];
  const auto payload = report.subspan(id == 0 ? 1 : 0);
  const bool by_control = interface_.out_endpoint == 0;
  flight.bytes.assign(by_control ? LIBUSB_CONTROL_SETUP_SIZE : 0, 0);
  if (by_control)
    libusb_fill_control_setup(
        flight.bytes.data(), kClassToInterface, kSetReport, static_cast<std::uint16_t>(kOutputReport | id),
        static_cast<std::uint16_t>(interface_.number), static_cast<std::uint16_t>(payload.size()));
  flight.bytes.insert(flight.bytes.end(), payload.begin(), payload.end());
  if (by_control)
    libusb_fill_control_transfer(flight.transfer.get(), handle_.get(), flight.bytes.data(), OnDone, &flight,
                                 kWriteTimeout_ms);
  else
    libusb_fill_interrupt_transfer(flight.transfer.get(), handle_.get(), interface_.out_endpoint,
                                   flight.bytes.data(), static_cast<int>(flight.bytes.size()), OnDone,
                                   &flight, kWriteTimeout_ms);
}

tl::unexpected<Error> LibusbChannel::Gone() const {
  return Fail(std::errc::no_such_device, "use " + interface_.port);
}

}  // namespace kaori::hid
