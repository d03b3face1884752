#include "hw-sim/links/usbredir/redir_wire.h"

#include <sys/socket.h>
#include <usbredirparser.h>

#include <algorithm>
#include <cerrno>

#include "drivers/base/log.h"
#include "hw-sim/devices/usb_descriptors.h"
#include "hw-sim/devices/usb_requests.h"

namespace kaori::sim {
namespace {

// The protocol's mark for an endpoint that a device does not have.
constexpr std::uint8_t kNoEndpoint = 255;
// The length of packets on endpoint 0, as the device descriptor says it.
constexpr std::uint16_t kControlPacketBytes = 64;

// The parser gives its user's pointer to every call-back: that of the wire.
RedirWire& Wire(void* priv) {
  return *static_cast<RedirWire*>(priv);
}
// Where the parser's call-backs lead.
RedirRequests& Requests(void* priv) {
  return Wire(priv).requests();
}

// A packet's data, which becomes ours with the call-back and is freed by the parser's own function.
class Data {
 public:
  Data(void* priv, std::uint8_t* bytes, int length)
      : parser_(Wire(priv).parser()), bytes_(bytes), length_(length) {}
  ~Data() { usbredirparser_free_packet_data(parser_, bytes_); }
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;
  std::span<const std::uint8_t> span() const { return {bytes_, static_cast<std::size_t>(length_)}; }

 private:
  usbredirparser* parser_;
  std::uint8_t* bytes_;
  int length_;
};

// Debug and information lines tell of every packet: only errors and warnings are logged.
void OnLog(void*, int level, const char* message) {
  if (level <= usbredirparser_warning) Log("usbredir: {}", message);
}

// The parser's convention: 0 where it would block, -1 where the peer is gone.
int OnRead(void* priv, std::uint8_t* data, int count) {
  const ssize_t got = ::recv(Wire(priv).pollable(), data, static_cast<std::size_t>(count), MSG_DONTWAIT);
  if (got > 0) return static_cast<int>(got);
  return got < 0 && (errno == EAGAIN || errno == EINTR) ? 0 : -1;
}

// As OnRead.
int OnWrite(void* priv, std::uint8_t* data, int count) {
  const ssize_t sent =
      ::send(Wire(priv).pollable(), data, static_cast<std::size_t>(count), MSG_DONTWAIT | MSG_NOSIGNAL);
  if (sent >= 0) return static_cast<int>(sent);
  return errno == EAGAIN || errno == EINTR ? 0 : -1;
}

void OnControl(void* priv, std::uint64_t id, usb_redir_control_packet_header* header, std::uint8_t* bytes,
               int length) {
  const Data data(priv, bytes, length);
  const UsbSetup setup{header->requesttype, header->request, header->value, header->index, header->length};
  Requests(priv).Control(id, setup, data.span());
}

void OnBulk(void* priv, std::uint64_t id, usb_redir_bulk_packet_header* header, std::uint8_t* bytes,
            int length) {
  const Data data(priv, bytes, length);
  // The upper 16 bits came with usb_redir_cap_32bits_bulk_length.
  const std::uint32_t asked = header->length | (std::uint32_t{header->length_high} << 16);
  Requests(priv).Bulk({id, header->endpoint, header->stream_id, asked}, data.span());
}

void OnInterrupt(void* priv, std::uint64_t id, usb_redir_interrupt_packet_header* header, std::uint8_t* bytes,
                 int length) {
  const Data data(priv, bytes, length);
  Requests(priv).InterruptOut(id, header->endpoint, data.span());
}

// Data that no device of ours reads is freed, too.
void OnIsochronous(void* priv, std::uint64_t, usb_redir_iso_packet_header*, std::uint8_t* bytes, int length) {
  const Data data(priv, bytes, length);
}

// Every call-back that the parser may call must be set; a null one would crash it.
void Bind(usbredirparser& parser) {
  parser.log_func = OnLog;
  parser.read_func = OnRead;
  parser.write_func = OnWrite;
  parser.hello_func = [](void* priv, usb_redir_hello_header*) { Requests(priv).Greeted(); };
  parser.reset_func = [](void*) {};  // What a host resets it configures anew.
  parser.set_configuration_func = [](void* priv, std::uint64_t id,
                                     usb_redir_set_configuration_header* header) {
    Requests(priv).SetConfiguration(id, header->configuration);
  };
  parser.get_configuration_func = [](void* priv, std::uint64_t id) { Requests(priv).GetConfiguration(id); };
  parser.set_alt_setting_func = [](void* priv, std::uint64_t id, usb_redir_set_alt_setting_header* header) {
    Requests(priv).SetAlternate(id, header->interface, header->alt);
  };
  parser.get_alt_setting_func = [](void* priv, std::uint64_t id, usb_redir_get_alt_setting_header* header) {
    Requests(priv).GetAlternate(id, header->interface);
  };
  parser.start_interrupt_receiving_func = [](void* priv, std::uint64_t id,
                                             usb_redir_start_interrupt_receiving_header* header) {
    Requests(priv).Listen(id, header->endpoint, true);
  };
  parser.stop_interrupt_receiving_func = [](void* priv, std::uint64_t id,
                                            usb_redir_stop_interrupt_receiving_header* header) {
    Requests(priv).Listen(id, header->endpoint, false);
  };
  parser.start_iso_stream_func = [](void* priv, std::uint64_t id, usb_redir_start_iso_stream_header* header) {
    Requests(priv).Isochronous(id, header->endpoint);
  };
  parser.stop_iso_stream_func = [](void*, std::uint64_t, usb_redir_stop_iso_stream_header*) {};
  parser.cancel_data_packet_func = [](void* priv, std::uint64_t id) { Requests(priv).Cancel(id); };
  parser.control_packet_func = OnControl;
  parser.bulk_packet_func = OnBulk;
  parser.iso_packet_func = OnIsochronous;
  parser.interrupt_packet_func = OnInterrupt;
}

std::uint8_t* Mutable(std::span<const std::uint8_t> data) {  // The parser copies, and does not change.
  return const_cast<std::uint8_t*>(data.data());
}

// Endpoints 0 to 15 towards the device, then 16 to 31 towards the host, as
// the protocol's tables have them.
std::size_t IndexOf(std::uint8_t address) {
  return static_cast<std::size_t>((address & 0x80) >> 3 | (address & 0x0F));
}

// In microframes at high speed, where a descriptor has an exponent; else in
// frames. Bulk endpoints have none.
std::uint8_t IntervalOf(const UsbEndpoint& endpoint, UsbSpeed speed) {
  if (endpoint.transfer == UsbTransfer::kBulk) return 0;
  if (speed != UsbSpeed::kHigh) return endpoint.interval;
  return static_cast<std::uint8_t>(std::min(255, 1 << std::clamp(endpoint.interval - 1, 0, 15)));
}

// The protocol's table of interfaces, 32 at most: further settings of one, and those for which there is no
// room, are in the descriptors alone.
usb_redir_interface_info_header InterfacesOf(const UsbContents& contents) {
  usb_redir_interface_info_header info{};
  for (const UsbInterface& interface : contents.interfaces) {
    auto* const end = info.interface + info.interface_count;
    if (end == std::end(info.interface) || std::find(info.interface, end, interface.number) != end) continue;
    const std::uint32_t n = info.interface_count++;
    info.interface[n] = interface.number;
    info.interface_class[n] = interface.kind;
    info.interface_subclass[n] = interface.subclass;
    info.interface_protocol[n] = interface.protocol;
  }
  return info;
}

// The protocol's table of endpoints: all 32, those that are not there included.
usb_redir_ep_info_header EndpointsOf(const UsbContents& contents, UsbSpeed speed) {
  usb_redir_ep_info_header info{};
  std::fill(std::begin(info.type), std::end(info.type), kNoEndpoint);
  // Endpoint 0 is in no descriptor, and there both ways.
  for (const std::size_t control : {IndexOf(0), IndexOf(kFromDevice)}) {
    info.type[control] = usb_redir_type_control;
    info.max_packet_size[control] = kControlPacketBytes;
  }
  for (const UsbEndpoint& endpoint : contents.endpoints) {
    const std::size_t n = IndexOf(endpoint.address);
    info.type[n] = static_cast<std::uint8_t>(endpoint.transfer);
    info.interval[n] = IntervalOf(endpoint, speed);
    info.interface[n] = endpoint.interface;
    info.max_packet_size[n] = endpoint.max_packet_bytes;
  }
  return info;
}

}  // namespace

void RedirWire::Destroy::operator()(usbredirparser* parser) const {
  usbredirparser_destroy(parser);
}

// Without 32-bit lengths a machine dies of a long bulk transfer. Streams and buffered bulk change the
// packets' form, so they are not offered. usbredirparser_fl_usb_host says which end of the cable this
// is; the parser sends its hello by itself.
RedirWire::RedirWire(UniqueFd socket, RedirRequests& requests)
    : socket_(std::move(socket)), requests_(requests), parser_(usbredirparser_create()) {
  parser_->priv = this;
  Bind(*parser_);
  std::uint32_t caps[USB_REDIR_CAPS_SIZE] = {};
  for (const int cap : {usb_redir_cap_connect_device_version, usb_redir_cap_ep_info_max_packet_size,
                        usb_redir_cap_64bits_ids, usb_redir_cap_32bits_bulk_length})
    usbredirparser_caps_set_cap(caps, cap);
  usbredirparser_init(parser_.get(), "kaori", caps, USB_REDIR_CAPS_SIZE, usbredirparser_fl_usb_host);
}

RedirWire::~RedirWire() = default;

bool RedirWire::Read() {
  return usbredirparser_do_read(parser_.get()) == 0;
}

bool RedirWire::Write() {
  return !has_to_write() || usbredirparser_do_write(parser_.get()) == 0;
}

bool RedirWire::has_to_write() const {
  return usbredirparser_has_data_to_write(parser_.get()) > 0;
}

void RedirWire::Describe(const UsbDescriptors& descriptors) {
  const UsbContents contents = ContentsOf(descriptors.configuration);
  auto interfaces = InterfacesOf(contents);
  usbredirparser_send_interface_info(parser_.get(), &interfaces);
  auto endpoints = EndpointsOf(contents, descriptors.speed);
  usbredirparser_send_ep_info(parser_.get(), &endpoints);
}

void RedirWire::Connect(const UsbDescriptors& descriptors) {
  usb_redir_device_connect_header header{static_cast<std::uint8_t>(descriptors.speed),
                                         descriptors.device_class,
                                         descriptors.device_subclass,
                                         descriptors.device_protocol,
                                         descriptors.vendor,
                                         descriptors.product,
                                         descriptors.release_bcd};
  usbredirparser_send_device_connect(parser_.get(), &header);
}

void RedirWire::Disconnect() {
  usbredirparser_send_device_disconnect(parser_.get());
}

void RedirWire::ConfigurationStatus(std::uint64_t id, RedirStatus status, std::uint8_t number) {
  usb_redir_configuration_status_header header{static_cast<std::uint8_t>(status), number};
  usbredirparser_send_configuration_status(parser_.get(), id, &header);
}

void RedirWire::AlternateStatus(std::uint64_t id, RedirStatus status, std::uint8_t interface) {
  usb_redir_alt_setting_status_header header{static_cast<std::uint8_t>(status), interface, 0};
  usbredirparser_send_alt_setting_status(parser_.get(), id, &header);
}

void RedirWire::ListenStatus(std::uint64_t id, std::uint8_t endpoint) {
  usb_redir_interrupt_receiving_status_header header{usb_redir_success, endpoint};
  usbredirparser_send_interrupt_receiving_status(parser_.get(), id, &header);
}

void RedirWire::IsochronousStatus(std::uint64_t id, std::uint8_t endpoint) {
  usb_redir_iso_stream_status_header header{usb_redir_inval, endpoint};
  usbredirparser_send_iso_stream_status(parser_.get(), id, &header);
}

void RedirWire::Control(std::uint64_t id, const UsbSetup& setup, RedirStatus status,
                        std::span<const std::uint8_t> data) {
  const bool reads = (setup.type & kFromDevice) != 0;
  const auto back = data.first(reads ? std::min<std::size_t>(data.size(), setup.length) : 0);
  // The length of the answer: what goes back, or how much of the host's data was taken.
  const std::size_t told = status != RedirStatus::kDone ? 0 : reads ? back.size() : setup.length;
  usb_redir_control_packet_header header{static_cast<std::uint8_t>(setup.type & kFromDevice),
                                         setup.request,
                                         setup.type,
                                         static_cast<std::uint8_t>(status),
                                         setup.value,
                                         setup.index,
                                         static_cast<std::uint16_t>(told)};
  usbredirparser_send_control_packet(parser_.get(), id, &header, Mutable(back),
                                     static_cast<int>(back.size()));
}

void RedirWire::InterruptIn(std::uint8_t endpoint, std::span<const std::uint8_t> data) {
  usb_redir_interrupt_packet_header header{endpoint, usb_redir_success,
                                           static_cast<std::uint16_t>(data.size())};
  // Id 0: this packet answers no request.
  usbredirparser_send_interrupt_packet(parser_.get(), 0, &header, Mutable(data),
                                       static_cast<int>(data.size()));
}

void RedirWire::InterruptOutDone(std::uint64_t id, std::uint8_t endpoint, std::size_t bytes) {
  usb_redir_interrupt_packet_header header{endpoint, usb_redir_success, static_cast<std::uint16_t>(bytes)};
  usbredirparser_send_interrupt_packet(parser_.get(), id, &header, nullptr, 0);
}

void RedirWire::Bulk(const RedirBulk& request, RedirStatus status, std::span<const std::uint8_t> data,
                     std::size_t bytes) {
  // Length in two halves, as in OnBulk.
  usb_redir_bulk_packet_header header{request.endpoint, static_cast<std::uint8_t>(status),
                                      static_cast<std::uint16_t>(bytes & 0xFFFF), request.stream,
                                      static_cast<std::uint16_t>(bytes >> 16)};
  usbredirparser_send_bulk_packet(parser_.get(), request.id, &header, Mutable(data),
                                  static_cast<int>(data.size()));
}

}  // namespace kaori::sim
