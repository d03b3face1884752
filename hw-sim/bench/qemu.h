// A box in QEMU, without acceleration: the image as it ships, with a bench's disk beside it.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "hw-sim/bench/protocols.h"
#include "hw-sim/bench/qmp.h"
#include "hw-sim/bench/waiter.h"

namespace kaori::bench {

struct QemuOptions {
  std::string image;       // The folder with bzImage, cmdline and kaori.disk; nothing in it is written.
  std::string bench_disk;  // See tests/hil/bench_disk.
  std::string folder;      // For sockets; the devices' are named as UsbSocketPath does.
  int width_px = 960;
  int height_px = 540;
  int heads = 1;
  int memory_mib = 512;
};

// The kernel's command line for the bench: that of the image, but a witness is started first, and becomes
// what the image names after it; and the serial line is the witness's.
std::string BenchCommandLine(const std::string& of_the_image);

std::vector<std::string> QemuCommand(const QemuOptions& options, const std::string& command_line);

class QemuDriver final : public PowerProtocol, public VideoProtocol {
 public:
  // The waiter outlives the driver.
  QemuDriver(QemuOptions options, Waiter& waiter) : options_(std::move(options)), waiter_(waiter) {}
  ~QemuDriver() override { Off(); }

  // Errors: those of the image's files and of starting the program; timed_out.
  Result<void> On() override;
  void Off() override;
  Result<void> Shoot(int head, const std::string& file) override;

  bool runs() const;
  pid_t process() const { return process_; }

 private:
  QemuOptions options_;
  Waiter& waiter_;
  pid_t process_ = -1;
  std::optional<Qmp> qmp_;
};

}  // namespace kaori::bench
