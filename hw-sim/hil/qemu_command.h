// QEMU's command line. Every machine of this project is started with it: those of checks, of `./box boot`, of
// the image's builder, and of what asks for it with `kaori-bench --command`.
#pragma once

#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "hw-sim/hil/architecture.h"
#include "hw-sim/hil/setup.h"

namespace kaori::hil {

// What a machine is, for all of its runs; a Setup says what differs for one check.
struct QemuOptions {
  // Of the image's programs and kernel.
  Architecture architecture = Architecture::kAmd64;
  // The folder with kernel, cmdline and kaori.disk; nothing in it is written.
  std::string image;
  // See tests/hil/bench_disk.
  std::string bench_disk{};
  // Empty: there is none.
  std::string bench_kernel{};
  // The program that makes an image which starts in the usual way: tests/hil/usual_image.
  std::string usual_image{};
  // With images of sticks: make_sticks of tests/hil/bench.sh.
  std::string sticks{};
  // With the dial box's shipped image and the chip's emulator: tests/firmware/chip.py. Empty: there is none.
  std::string chip{};
  // For sockets and logs; the devices' sockets are named as UsbSocketPath does.
  std::string folder;
  // Of the screen, where the setup does not say otherwise.
  int width_px = 960;
  int height_px = 540;
  // Of the guest's memory; the image plays with 512.
  int memory_mib = 512;
  // Of the kernel, on the serial line of a machine without an agent; 7 shows all.
  int log_level = 6;
  // The screen is shown in a window; otherwise nowhere.
  bool window = false;
  // The bench draws for the machine, as a graphics card would (Graphics::kVirgl), where the setup does not say who draws.
  bool draws = false;
};

// Who draws for a machine: never kUsual. Pure.
Graphics GraphicsOf(const QemuOptions& options, const Setup& setup);

// The kernel's command line, of an image's folder. Errors: those of ReadFile.
Result<std::string> ReadCommandLine(const std::string& image);

// The kernel's command line for the bench: that of the image, but the in-guest agent is started first and
// then becomes what the image names; the serial line is the agent's. The kernel takes the last of equal
// words, so the image's own stay and count no more; their values go on as kaori.root and the like. Pure.
std::string BenchCommandLine(const std::string& of_the_image, const std::string& bench_disk = "/dev/vdb");

// The bench's disk in the machine: the second one on virtio, or the first where the image's is elsewhere. Pure.
std::string BenchDisk(const Setup& setup);

// The kernel's command line as an image for USB has it: the kernel authorises what it finds there. Pure.
std::string OnUsb(std::string line);

// The same for a machine without an agent: kernel, systemd and journal write their log to the serial line, the kernel as
// much as the options' log_level says. Pure.
std::string LoggedCommandLine(const QemuOptions& options, const std::string& of_the_image);

// The program and its arguments, for exec. `command_line` is the kernel's; `disk` is the
// image's, or a copy of it. Reads no file. Pure.
std::vector<std::string> QemuCommand(const QemuOptions& options, const Setup& setup,
                                     const std::string& command_line, const std::string& disk);

// Of the screen, in pixels: the setup's, or else the machine's.
int WidthOf(const QemuOptions& options, const Setup& setup);
int HeightOf(const QemuOptions& options, const Setup& setup);

// The folder with the kernel.
const std::string& ImageOf(const QemuOptions& options, const Setup& setup);

// What the loudspeaker of the machine's sound card played, as a WAV file.
std::string SoundPath(const QemuOptions& options);

// Where QEMU's VNC server of that output listens, for VncScreen.
std::string ScreenPath(const QemuOptions& options, int head);

// Where QEMU's test protocol listens, for MachineLines; of a machine with an agent that is no PC.
std::string LinesPath(const QemuOptions& options);

// What a machine without an agent said on its serial line.
std::string ConsolePath(const QemuOptions& options);

}  // namespace kaori::hil
