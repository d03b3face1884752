#include "drivers/hid/libusb_session.h"

#include <libusb.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>

#include <array>
#include <utility>

#include <fmt/format.h>

namespace kaori::hid {
namespace {

constexpr std::uint8_t kHidDescriptorKind = 0x21;  // HID 1.11, section 6.2.1.
constexpr std::uint8_t kReportDescriptorKind = 0x22;
// The longest chain of hubs.
constexpr int kMaxPortDepth = 7;  // USB 3.2, section 10.

struct FreePollfds {
  void operator()(const libusb_pollfd** list) const { libusb_free_pollfds(list); }
};
struct FreeList {
  void operator()(libusb_device** list) const { libusb_free_device_list(list, 1); }
};
struct FreeConfig {
  void operator()(libusb_config_descriptor* config) const { libusb_free_config_descriptor(config); }
};

// "1-4.2" as Linux names it; empty for a root hub.
std::string PortOf(libusb_device* device) {
  std::array<std::uint8_t, kMaxPortDepth> ports{};
  const int depth = libusb_get_port_numbers(device, ports.data(), kMaxPortDepth);
  if (depth <= 0) return {};
  std::string port = fmt::format("{}-{}", libusb_get_bus_number(device), ports[0]);
  for (std::size_t n = 1; n < static_cast<std::size_t>(depth); ++n) port += fmt::format(".{}", ports[n]);
  return port;
}

// The length of the report descriptor, out of the class descriptor behind the
// interface's own (HID 1.11, section 6.2.1: bDescriptorType at byte 6,
// wDescriptorLength at bytes 7 and 8). 0 where it is missing or torn.
std::uint16_t ReportDescriptorBytes(std::span<const std::uint8_t> extra) {
  while (extra.size() >= 2 && extra[0] >= 2 && extra[0] <= extra.size()) {
    const auto one = extra.first(extra[0]);
    if (one[1] == kHidDescriptorKind && one.size() >= 9 && one[6] == kReportDescriptorKind)
      return static_cast<std::uint16_t>(one[7] | (one[8] << 8));
    extra = extra.subspan(extra[0]);
  }
  return 0;
}

// The endpoints and the class descriptor of one interface.
UsbHidInterface Described(const libusb_interface_descriptor& given) {
  UsbHidInterface described;
  described.number = given.bInterfaceNumber;
  if (given.extra_length > 0)
    described.descriptor_bytes =
        ReportDescriptorBytes({given.extra, static_cast<std::size_t>(given.extra_length)});
  for (const auto& endpoint : std::span(given.endpoint, given.bNumEndpoints)) {
    if ((endpoint.bmAttributes & 3u) != LIBUSB_TRANSFER_TYPE_INTERRUPT) continue;
    const bool in = (endpoint.bEndpointAddress & LIBUSB_ENDPOINT_IN) != 0;
    (in ? described.in_endpoint : described.out_endpoint) = endpoint.bEndpointAddress;
    // Bits 11 and 12 are the extra transactions of a high-speed endpoint (USB 2.0, table 9-13).
    if (in) described.in_packet_bytes = endpoint.wMaxPacketSize & 0x7FFu;
  }
  return described;
}

// Devices without a port are root hubs, and devices that are not configured have no interfaces yet.
void AddInterfaces(libusb_device* device, std::vector<UsbHidInterface>& into) {
  const std::string port = PortOf(device);
  libusb_config_descriptor* raw = nullptr;
  libusb_device_descriptor identity{};
  if (port.empty() || libusb_get_device_descriptor(device, &identity) != 0 ||
      libusb_get_active_config_descriptor(device, &raw) != 0)
    return;
  const std::unique_ptr<libusb_config_descriptor, FreeConfig> config(raw);
  for (const auto& interface : std::span(config->interface, config->bNumInterfaces)) {
    if (interface.num_altsetting < 1 || interface.altsetting[0].bInterfaceClass != LIBUSB_CLASS_HID) continue;
    UsbHidInterface described = Described(interface.altsetting[0]);
    if (described.in_endpoint == 0 || described.in_packet_bytes == 0) continue;
    described.port = described.number == 0
                         ? port
                         : fmt::format("{}:{}.{}", port, config->bConfigurationValue, described.number);
    described.vendor = identity.idVendor;
    described.product = identity.idProduct;
    described.device.reset(libusb_ref_device(device));
    into.push_back(std::move(described));
  }
}

}  // namespace

// Codes of libusb 1.0. Other failures are io_error: the caller opens anew, which tells more.
tl::unexpected<Error> FailUsb(int code, std::string attempt) {
  switch (code) {
    case LIBUSB_ERROR_NO_DEVICE:
    case LIBUSB_ERROR_NOT_FOUND:
      return Fail(std::errc::no_such_device, std::move(attempt));
    case LIBUSB_ERROR_ACCESS:
      return Fail(std::errc::permission_denied, std::move(attempt));
    case LIBUSB_ERROR_BUSY:
      return Fail(std::errc::device_or_resource_busy, std::move(attempt));
    case LIBUSB_ERROR_NO_MEM:
      return Fail(std::errc::not_enough_memory, std::move(attempt));
    default:
      return Fail(std::errc::io_error, std::move(attempt));
  }
}

void UsbHidInterface::Unref::operator()(libusb_device* used) const {
  libusb_unref_device(used);
}
void LibusbSession::Exit::operator()(libusb_context* context) const {
  libusb_exit(context);
}

Result<std::unique_ptr<LibusbSession>> LibusbSession::Open() {
  UniqueFd epoll(::epoll_create1(EPOLL_CLOEXEC));
  UniqueFd waiting(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  if (!epoll.valid() || !waiting.valid()) return FailErrno("watch USB");
  libusb_context* context = nullptr;
  if (const int code = libusb_init(&context); code != 0) return FailUsb(code, "open libusb");
  return std::unique_ptr<LibusbSession>(new LibusbSession(context, std::move(epoll), std::move(waiting)));
}

// The notifiers are set before the list is read: a descriptor that comes between both is
// added twice at worst, which epoll refuses harmlessly.
LibusbSession::LibusbSession(libusb_context* context, UniqueFd epoll, UniqueFd waiting)
    : epoll_(std::move(epoll)), readable_(std::move(waiting)), context_(context) {
  Watch(readable_.get(), EPOLLIN);
  libusb_set_pollfd_notifiers(context, OnAdded, OnRemoved, this);
  const std::unique_ptr<const libusb_pollfd*, FreePollfds> fds(libusb_get_pollfds(context));
  for (const libusb_pollfd** fd = fds.get(); fd != nullptr && *fd != nullptr; ++fd)
    Watch((*fd)->fd, (*fd)->events);
}

LibusbSession::~LibusbSession() {
  // The context closes after this and would tell of each descriptor that it removes.
  libusb_set_pollfd_notifiers(context_.get(), nullptr, nullptr, nullptr);
}

void LibusbSession::Watch(int fd, short events) {
  epoll_event event{};
  event.events = static_cast<std::uint32_t>(events);  // POLLIN and its kin have epoll's values on Linux.
  event.data.fd = fd;
  ::epoll_ctl(epoll_.get(), EPOLL_CTL_ADD, fd, &event);
}

void LibusbSession::OnAdded(int fd, short events, void* self) {
  static_cast<LibusbSession*>(self)->Watch(fd, events);
}

void LibusbSession::OnRemoved(int fd, void* self) {
  ::epoll_ctl(static_cast<LibusbSession*>(self)->epoll_.get(), EPOLL_CTL_DEL, fd, nullptr);
}

// Makes the session's descriptor readable by hand: for what has come already, which libusb's own descriptors
// no longer tell.
void LibusbSession::SetReadable(bool readable) {
  eventfd_t count = 0;
  if (readable)
    ::eventfd_write(readable_.get(), 1);
  else
    ::eventfd_read(readable_.get(), &count);  // Non-blocking: empty is as good.
}

// LIBUSB_ERROR_INTERRUPTED is a signal that came in between; the descriptor stays
// readable, so that the next call goes on.
Result<void> LibusbSession::Handle() {
  timeval at_once{};
  const int code = libusb_handle_events_timeout_completed(context_.get(), &at_once, nullptr);
  if (code != 0 && code != LIBUSB_ERROR_INTERRUPTED) return FailUsb(code, "handle USB events");
  return {};
}

// The result counts for nothing: whoever closes looks at its own transfers.
void LibusbSession::HandleFor(int ms) {
  timeval wait{.tv_sec = 0, .tv_usec = suseconds_t{ms} * 1000};
  libusb_handle_events_timeout_completed(context_.get(), &wait, nullptr);
}

Result<std::vector<UsbHidInterface>> LibusbSession::Interfaces() const {
  libusb_device** raw = nullptr;
  const auto count = libusb_get_device_list(context_.get(), &raw);
  if (count < 0) return FailUsb(static_cast<int>(count), "list USB devices");
  const std::unique_ptr<libusb_device*, FreeList> list(raw);
  std::vector<UsbHidInterface> found;
  for (libusb_device* device : std::span(raw, static_cast<std::size_t>(count))) AddInterfaces(device, found);
  return found;
}

}  // namespace kaori::hid
