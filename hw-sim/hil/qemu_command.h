// The words with which QEMU is started for a place on the bench.
#pragma once

#include <string>
#include <vector>

#include "hw-sim/hil/setup.h"

namespace kaori::hil {

struct QemuOptions {
  std::string image;           // The folder with bzImage, cmdline and kaori.disk; nothing in it is written.
  std::string bench_disk{};    // See tests/hil/bench_disk.
  std::string bench_kernel{};  // Empty: there is none.
  std::string folder;          // For sockets; the devices' are named as UsbSocketPath does.
  int width_px = 960;
  int height_px = 540;
  int heads = 1;
  int memory_mib = 512;
};

// The kernel's command line for the bench: that of the image, but a witness is started first, and becomes
// what the image names after it; and the serial line is the witness's.
std::string BenchCommandLine(const std::string& of_the_image);

// `disk` is the image's, or a copy of it.
std::vector<std::string> QemuCommand(const QemuOptions& options, const Setup& setup,
                                     const std::string& command_line, const std::string& disk);

// Of the screen.
int WidthOf(const QemuOptions& options, const Setup& setup);
int HeightOf(const QemuOptions& options, const Setup& setup);

// What the loudspeaker of the machine's sound card played, as a WAV file.
std::string SoundPath(const QemuOptions& options);

}  // namespace kaori::hil
