// One connection that speaks usbredir, at the end where the device is ("usb-host" in the
// protocol's words): libusbredirparser on a socket.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "drivers/base/unique_fd.h"
#include "hw-sim/devices/usb_device.h"

struct usbredirparser;

namespace kaori::sim {

// How a transfer ended; the numbers are those of the protocol (usbredir protocol,
// usb_redir_success and its like).
enum class RedirStatus : std::uint8_t { kDone, kCancelled, kInvalid, kIoError, kStalled };

// One bulk transfer that the machine asked for; also the header of its answer.
struct RedirBulk {
  std::uint64_t id = 0;            // Which request it is; the answer repeats it.
  std::uint8_t endpoint = 0;       // Bit 7: towards the host.
  std::uint32_t stream = 0;        // Of USB 3; 0 for ours.
  std::uint32_t length_bytes = 0;  // What the host has room for, or sends.
};

// What a machine asks of the device. Called inside RedirWire::Read; data is borrowed for the call.
// Each id is answered once, by the wire's verb of the same name, at once or later; answers of one
// endpoint keep the order of the requests.
class RedirRequests {
 public:
  virtual ~RedirRequests() = default;
  virtual void Greeted() = 0;  // The machine said hello: a device may be announced.
  // Number 0 takes the configuration away.
  virtual void SetConfiguration(std::uint64_t id, std::uint8_t number) = 0;
  virtual void GetConfiguration(std::uint64_t id) = 0;
  // Our interfaces have setting 0 alone.
  virtual void SetAlternate(std::uint64_t id, std::uint8_t interface, std::uint8_t number) = 0;
  virtual void GetAlternate(std::uint64_t id, std::uint8_t interface) = 0;
  // A request on endpoint 0; `data` is what the host sends with it.
  virtual void Control(std::uint64_t id, const UsbSetup& setup, std::span<const std::uint8_t> data) = 0;
  virtual void Listen(std::uint64_t id, std::uint8_t endpoint, bool begins) = 0;  // To an interrupt endpoint.
  // A report for an OUT endpoint, to be acknowledged by InterruptOutDone.
  virtual void InterruptOut(std::uint64_t id, std::uint8_t endpoint, std::span<const std::uint8_t> data) = 0;
  // For an IN endpoint `data` is empty: the machine asks for data.
  virtual void Bulk(const RedirBulk& request, std::span<const std::uint8_t> data) = 0;
  virtual void Isochronous(std::uint64_t id, std::uint8_t endpoint) = 0;  // Asked to begin; we have none.
  virtual void Cancel(std::uint64_t id) = 0;  // A transfer that may be done already.
};

// The packets of the protocol as calls, without its structures. The protocol is that of usbredir 0.6 and
// later; what goes out waits in the parser until Write. One thread; nothing blocks.
class RedirWire {
 public:
  // Owns the socket, a connected stream that does not block; borrows the requests. Says hello.
  RedirWire(UniqueFd socket, RedirRequests& requests);
  ~RedirWire();
  RedirWire(const RedirWire&) = delete;
  RedirWire& operator=(const RedirWire&) = delete;

  int pollable() const { return socket_.get(); }

  // Reads everything that waits, and calls the requests. False: the machine is gone, or breaks the
  // protocol; the wire must not be used any further.
  bool Read();
  // Sends what the socket has room for. False: as Read.
  bool Write();
  // The caller watches the socket for room while this is so.
  bool has_to_write() const;

  // What lies behind the cable; said before it is connected, and anew before each answer to a
  // configuration, as the protocol wants it. Connect: the cable is in; Disconnect: it was pulled.
  void Describe(const UsbDescriptors& descriptors);
  // The machine enumerates the device then.
  void Connect(const UsbDescriptors& descriptors);
  // The machine forgets the device and all that it asked of it.
  void Disconnect();

  // Answers to requests; `id` is the request's. Nothing is sent before Write.

  // Answers SetConfiguration and GetConfiguration; `number` is the one that holds now.
  void ConfigurationStatus(std::uint64_t id, RedirStatus status, std::uint8_t number);
  // Answers SetAlternate and GetAlternate; the setting is 0.
  void AlternateStatus(std::uint64_t id, RedirStatus status, std::uint8_t interface);
  // Answers Listen; it always succeeds.
  void ListenStatus(std::uint64_t id, std::uint8_t endpoint);
  // Answers Isochronous: there is no such endpoint.
  void IsochronousStatus(std::uint64_t id, std::uint8_t endpoint);
  // `data` goes back to a host that reads, wLength bytes at most; of a request that
  // writes the whole length is acknowledged.
  void Control(std::uint64_t id, const UsbSetup& setup, RedirStatus status,
               std::span<const std::uint8_t> data);
  // Data that nobody asked for one by one: the machine listens to the endpoint.
  void InterruptIn(std::uint8_t endpoint, std::span<const std::uint8_t> data);
  // An output report of so many bytes has arrived.
  void InterruptOutDone(std::uint64_t id, std::uint8_t endpoint, std::size_t bytes);
  // Of an OUT transfer `bytes` are acknowledged, and no data goes back.
  void Bulk(const RedirBulk& request, RedirStatus status, std::span<const std::uint8_t> data,
            std::size_t bytes);

  // For the parser's call-backs, which know the wire alone.
  RedirRequests& requests() { return requests_; }
  usbredirparser* parser() { return parser_.get(); }

 private:
  struct Destroy {
    void operator()(usbredirparser* parser) const;
  };
  UniqueFd socket_;
  RedirRequests& requests_;
  // Keeps what is read in part and what is to be written.
  std::unique_ptr<usbredirparser, Destroy> parser_;
};

}  // namespace kaori::sim
