#include "tests/hw-sim/usb_machine.h"

#include <sys/socket.h>
#include <sys/un.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace kaori::sim {
namespace {

UsbMachine& Machine(void* priv) {
  return *static_cast<UsbMachine*>(priv);
}

UsbBytes Taken(std::uint8_t* data, int length) {
  UsbBytes bytes(data, data + length);
  usbredirparser_free_packet_data(nullptr, data);
  return bytes;
}

void OnControl(void* priv, std::uint64_t id, usb_redir_control_packet_header* header, std::uint8_t* data,
               int length) {
  Machine(priv).answers[id] = {header->status, header->length, Taken(data, length)};
}

void OnInterrupt(void* priv, std::uint64_t id, usb_redir_interrupt_packet_header* header, std::uint8_t* data,
                 int length) {
  if ((header->endpoint & 0x80) != 0)
    Machine(priv).reports.push_back(Taken(data, length));
  else
    Machine(priv).interrupts_done.push_back(id);
}

void OnBulk(void* priv, std::uint64_t id, usb_redir_bulk_packet_header* header, std::uint8_t* data,
            int length) {
  Machine(priv).bulk.emplace_back(id, Taken(data, length));
  Machine(priv).bulk_status[id] = header->status;
}

void Bind(usbredirparser& parser) {
  parser.log_func = [](void*, int, const char*) {};
  parser.hello_func = [](void*, usb_redir_hello_header*) {};
  parser.device_connect_func = [](void* priv, usb_redir_device_connect_header* header) {
    Machine(priv).device = *header;
    Machine(priv).order.emplace_back("connect");
  };
  parser.device_disconnect_func = [](void* priv) { Machine(priv).order.emplace_back("disconnect"); };
  parser.interface_info_func = [](void* priv, usb_redir_interface_info_header* header) {
    Machine(priv).interfaces = *header;
    Machine(priv).order.emplace_back("interfaces");
  };
  parser.ep_info_func = [](void* priv, usb_redir_ep_info_header* header) {
    Machine(priv).endpoints = *header;
    Machine(priv).order.emplace_back("endpoints");
  };
  parser.configuration_status_func = [](void* priv, std::uint64_t,
                                        usb_redir_configuration_status_header* header) {
    Machine(priv).configuration_status = header->status;
  };
  parser.alt_setting_status_func = [](void* priv, std::uint64_t,
                                      usb_redir_alt_setting_status_header* header) {
    Machine(priv).alternate_status = header->status;
  };
  parser.interrupt_receiving_status_func = [](void*, std::uint64_t,
                                              usb_redir_interrupt_receiving_status_header*) {};
  parser.control_packet_func = OnControl;
  parser.interrupt_packet_func = OnInterrupt;
  parser.bulk_packet_func = OnBulk;
}

}  // namespace

UsbMachine::UsbMachine(const std::string& path)
    : listener_(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, path.c_str(), path.size());
  const bool bound =
      ::bind(listener_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  if (!bound) std::perror("bind");
  ::listen(listener_.get(), 1);
}

void UsbMachine::Greet() {
  parser_.reset(usbredirparser_create());
  parser_->priv = this;
  Bind(*parser_);
  parser_->read_func = [](void* priv, std::uint8_t* data, int count) {
    const ssize_t got =
        ::recv(Machine(priv).socket_.get(), data, static_cast<std::size_t>(count), MSG_DONTWAIT);
    return got > 0 ? static_cast<int>(got) : got < 0 && errno == EAGAIN ? 0 : -1;
  };
  parser_->write_func = [](void* priv, std::uint8_t* data, int count) {
    return static_cast<int>(
        ::send(Machine(priv).socket_.get(), data, static_cast<std::size_t>(count), MSG_NOSIGNAL));
  };
  std::uint32_t caps[USB_REDIR_CAPS_SIZE] = {};
  for (int cap = 0; cap <= usb_redir_cap_bulk_receiving; ++cap) usbredirparser_caps_set_cap(caps, cap);
  usbredirparser_init(parser_.get(), "a machine", caps, USB_REDIR_CAPS_SIZE, 0);
}

void UsbMachine::Step() {
  const int caller = ::accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (caller >= 0) {
    socket_ = UniqueFd(caller);
    Greet();
  }
  if (!called()) return;
  if (usbredirparser_do_read(parser_.get()) != 0) return HangUp();
  while (usbredirparser_has_data_to_write(parser_.get()) > 0)
    if (usbredirparser_do_write(parser_.get()) != 0) return HangUp();
}

void UsbMachine::HangUp() {
  parser_.reset();
  socket_.reset();
}

std::uint64_t UsbMachine::Ask(const UsbSetup& setup, UsbBytes data) {
  usb_redir_control_packet_header header{static_cast<std::uint8_t>(setup.type & 0x80),
                                         setup.request,
                                         setup.type,
                                         0,
                                         setup.value,
                                         setup.index,
                                         setup.length};
  usbredirparser_send_control_packet(parser_.get(), next_id_, &header, data.data(),
                                     static_cast<int>(data.size()));
  return next_id_++;
}

void UsbMachine::Configure(std::uint8_t number) {
  usb_redir_set_configuration_header header{number};
  usbredirparser_send_set_configuration(parser_.get(), next_id_++, &header);
}

void UsbMachine::SetAlternate(std::uint8_t interface, std::uint8_t number) {
  usb_redir_set_alt_setting_header header{interface, number};
  usbredirparser_send_set_alt_setting(parser_.get(), next_id_++, &header);
}

void UsbMachine::Listen(std::uint8_t endpoint) {
  usb_redir_start_interrupt_receiving_header header{endpoint};
  usbredirparser_send_start_interrupt_receiving(parser_.get(), next_id_++, &header);
}

void UsbMachine::StopListening(std::uint8_t endpoint) {
  usb_redir_stop_interrupt_receiving_header header{endpoint};
  usbredirparser_send_stop_interrupt_receiving(parser_.get(), next_id_++, &header);
}

std::uint64_t UsbMachine::SendInterrupt(std::uint8_t endpoint, UsbBytes data) {
  usb_redir_interrupt_packet_header header{endpoint, 0, static_cast<std::uint16_t>(data.size())};
  usbredirparser_send_interrupt_packet(parser_.get(), next_id_, &header, data.data(),
                                       static_cast<int>(data.size()));
  return next_id_++;
}

std::uint64_t UsbMachine::AskBulk(std::uint8_t endpoint, std::uint32_t bytes) {
  usb_redir_bulk_packet_header header{endpoint, 0, static_cast<std::uint16_t>(bytes & 0xFFFF), 0,
                                      static_cast<std::uint16_t>(bytes >> 16)};
  usbredirparser_send_bulk_packet(parser_.get(), next_id_, &header, nullptr, 0);
  return next_id_++;
}

void UsbMachine::Cancel(std::uint64_t id) {
  usbredirparser_send_cancel_data_packet(parser_.get(), id);
}

}  // namespace kaori::sim
