#include "hw-sim/hil/qemu_command.h"

#include <algorithm>
#include <initializer_list>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "hw-sim/links/usbredir/usb_rig.h"

namespace kaori::hil {
namespace {

// Seven sockets of the rig, and one for unauthorised devices.
constexpr int kUsbPorts = 8;
// A PC's in two parts, with a flash chip for what it keeps, of Debian's package ovmf.
constexpr const char* kKeepingFirmware = "/usr/share/OVMF/OVMF_CODE_4M.fd";
// The same with Secure Boot, whose variables only it can write, in system management mode.
constexpr const char* kSecureFirmware = "/usr/share/OVMF/OVMF_CODE_4M.secboot.fd";

// The value of the last word "name=value"; empty where there is none.
std::string WordOf(const std::string& line, const std::string& name) {
  std::istringstream words(line);
  std::string value;
  for (std::string word; words >> word;)
    if (word.starts_with(name + "=")) value = word.substr(name.size() + 1);
  return value;
}

bool IsPc(const QemuOptions& options) {
  return options.architecture == Architecture::kAmd64;
}

void Add(std::vector<std::string>& command, std::initializer_list<std::string> words) {
  command.insert(command.end(), words);
}

// Each output has a VNC server of its own: its client is what plugs in a screen and sets its size.
void AddScreens(const QemuOptions& options, const Setup& setup, std::vector<std::string>& command) {
  const std::string size =
      fmt::format("id=screens,xres={},yres={}", WidthOf(options, setup), HeightOf(options, setup));
  const Graphics graphics = GraphicsOf(options, setup);
  if (graphics == Graphics::kVirgl)
    // A window as large as the screen of the machine: XScreen finds the picture in it.
    return Add(command, {"-display", "sdl,gl=on", "-device", "virtio-gpu-gl-pci," + size});
  Add(command, {"-display", options.window ? "gtk" : "none"});
  if (graphics == Graphics::kVirtio)
    Add(command, {"-device", fmt::format("virtio-gpu-pci,{},max_outputs={}{}", size,
                                         std::max(1, setup.screens), setup.tells_size ? "" : ",edid=off")});
  for (int head = 0; head < setup.screens; ++head)
    Add(command, {"-vnc", fmt::format("unix:{},id=vnc{},display=screens,head={}", ScreenPath(options, head),
                                      head, head)});
  // A machine without graphics gets none of these devices.
  if (graphics == Graphics::kVga) Add(command, {"-device", "VGA,edid=on," + size});
}

// A file as QEMU opens it for a drive: with a log each write goes there too, once it is done.
std::string LoggedFile(const std::string& file, const std::string& log) {
  if (log.empty()) return fmt::format("format=raw,file={}", file);
  return fmt::format("driver=blklogwrites,file.driver=file,file.filename={},log.driver=file,log.filename={}",
                     file, log);
}

// "disk" is the drive's name, whatever it is attached to.
void AddDisk(const QemuOptions& options, const Setup& setup, const std::string& disk,
             std::vector<std::string>& command) {
  // "snapshot=on" writes to a temporary file: the image stays as it ships, whatever the guest does.
  const char* written = setup.keeps_disk ? "cache=writethrough" : "snapshot=on";
  Add(command, {"-drive", fmt::format("if=none,id=disk,{},{}", LoggedFile(disk, setup.write_log),
                                      setup.write_log.empty() ? written : "cache=writeback")});
  if (setup.disk_bus == DiskBus::kSata) {
    // A PC's chip set has its own.
    if (!IsPc(options)) Add(command, {"-device", "ahci,id=ide"});
    return Add(command, {"-device", IsPc(options) ? "ide-hd,drive=disk" : "ide-hd,drive=disk,bus=ide.0"});
  }
  if (setup.disk_bus == DiskBus::kNvme) return Add(command, {"-device", "nvme,drive=disk,serial=1"});
  // A controller of its own, so that the rig's has its ports for itself.
  if (setup.disk_bus == DiskBus::kUsb)
    return Add(command, {"-device", "qemu-xhci,id=medium", "-device",
                         "usb-storage,drive=disk,bus=medium.0,id=medium-disk"});
  if (setup.disk_bus == DiskBus::kSd)
    return Add(command, {"-device", "sdhci-pci", "-device", "sd-card,drive=disk"});
  Add(command, {"-device", "virtio-blk-pci,drive=disk"});
}

// The guest draws by itself.
void AddProcessors(const QemuOptions& options, const Setup& setup, std::vector<std::string>& command) {
  if (setup.counts_instructions)
    // With -icount an instruction takes 2^shift ns of the guest's time, and
    // idle time is skipped: runs repeat.
    Add(command, {"-accel", "tcg,thread=single", "-icount", "shift=0,sleep=off"});
  else
    Add(command, {"-accel", "tcg,thread=multi"});
  constexpr int kStock_mib = 2048;
  const std::string_view usual = PlatformOf(options.architecture).processor;
  Add(command,
      {"-cpu", std::string(setup.stock ? "max" : usual), "-smp", setup.counts_instructions ? "1" : "2", "-m",
       std::to_string(setup.stock ? kStock_mib : options.memory_mib)});
}

// QEMU's chip set is strapped so that its watchdog resets nothing, unless it is told; where there is none, one on PCI serves.
void AddWatchdog(const QemuOptions& options, const Setup& setup, std::vector<std::string>& command) {
  if (!setup.watchdog_resets) return;
  if (IsPc(options)) return Add(command, {"-global", "ICH9-LPC.noreboot=off"});
  Add(command, {"-device", "i6300esb"});
}

// Two flash chips: the firmware, and what it keeps. With Secure Boot waking up from S3 is a way past it, which is shut.
void AddKeepingFirmware(const Setup& setup, std::vector<std::string>& command) {
  if (setup.secure_boot)
    Add(command,
        {"-global", "driver=cfi.pflash01,property=secure,value=on", "-global", "ICH9-LPC.disable_s3=1"});
  Add(command, {"-drive", fmt::format("if=pflash,unit=0,format=raw,readonly=on,file={}",
                                      setup.secure_boot ? kSecureFirmware : kKeepingFirmware)});
  Add(command, {"-drive", "if=pflash,unit=1," + LoggedFile(setup.variables, setup.variables_log)});
}

// With firmware the machine starts from its disk, as a real one; else QEMU loads the kernel, which is
// quicker.
void AddKernel(const QemuOptions& options, const Setup& setup, const std::string& command_line,
               std::vector<std::string>& command) {
  if (!setup.variables.empty()) return AddKeepingFirmware(setup, command);
  const Platform& platform = PlatformOf(options.architecture);
  if (setup.firmware) return Add(command, {"-bios", std::string(platform.firmware)});
  const std::string of_the_image = fmt::format("{}/{}", ImageOf(options, setup), platform.kernel);
  Add(command, {"-kernel", setup.bench_kernel ? options.bench_kernel : of_the_image});
  if (!setup.initramfs.empty()) Add(command, {"-initrd", setup.initramfs});
  Add(command, {"-append", command_line});
}

// The port after the last socket is free, for an unauthorised device. One xHCI controller whose USB 2
// and USB 3 ports are as many, each with one device.
void AddUsb(const QemuOptions& options, const Setup& setup, std::vector<std::string>& command) {
  Add(command, {"-device", fmt::format("qemu-xhci,id=xhci,p2={0},p3={0}", kUsbPorts)});
  for (std::size_t n = 0; n < sim::kUsbSockets.size(); ++n) {
    const std::string path = sim::UsbSocketPath(options.folder, sim::kUsbSockets[n]);
    // QEMU listens and does not wait: a machine starts with nothing plugged in.
    Add(command, {"-chardev", fmt::format("socket,id=usb{},path={},server=on,wait=off", n, path)});
    Add(command, {"-device", fmt::format("usb-redir,chardev=usb{},bus=xhci.0,port={}", n, n + 1)});
  }
  // A storage stick of 64 MiB of zeroes, and a network that leads nowhere, for unauthorised devices.
  Add(command, {"-blockdev", "null-co,node-name=stick,size=67108864,read-zeroes=on"});
  Add(command, {"-netdev", "hubport,id=net,hubid=0"});
  // As QemuDriver::PlugUnauthorised does it.
  if (setup.other_stick)
    Add(command,
        {"-device", fmt::format("usb-storage,drive=stick,id=unauthorised,bus=xhci.0,port={}", kUsbPorts)});
}

// A PC has no lines. The protocol is one more server beside the machine, whose time and processors stay its own.
void AddLines(const QemuOptions& options, std::vector<std::string>& command) {
  if (IsPc(options)) return;
  Add(command,
      {"-qtest", fmt::format("unix:{},server=on,wait=off", LinesPath(options)), "-qtest-log", "none"});
}

// Intel's, as PCs have it, in a network of the machine and this computer alone (slirp): the box is 10.0.2.15 there.
void AddNetworkCard(const Setup& setup, std::vector<std::string>& command) {
  if (setup.desk_port == 0) return;
  Add(command, {"-netdev", fmt::format("user,id=wired,restrict=on,hostfwd=tcp:127.0.0.1:{}-10.0.2.15:8443",
                                       setup.desk_port)});
  Add(command, {"-device", "e1000e,netdev=wired,romfile="});
}

// Two cards: a loudspeaker that the bench hears, and a microphone that hears silence. QEMU's sound to a file
// has no microphone, and neither has its card on USB, which takes the port that is left free.
void AddSound(const QemuOptions& options, const Setup& setup, std::vector<std::string>& command) {
  if (!setup.sound && !setup.usb_sound) return;
  Add(command, {"-audiodev", fmt::format("wav,id=sound,path={},out.frequency=48000", SoundPath(options))});
  if (setup.usb_sound)
    return Add(command, {"-device", fmt::format("usb-audio,audiodev=sound,bus=xhci.0,port={}", kUsbPorts)});
  Add(command, {"-device", "ich9-intel-hda,id=out", "-device", "hda-output,bus=out.0,audiodev=sound"});
  Add(command, {"-audiodev", "none,id=silence", "-device", "ich9-intel-hda,id=in", "-device",
                "hda-micro,bus=in.0,audiodev=silence"});
}

}  // namespace

Graphics GraphicsOf(const QemuOptions& options, const Setup& setup) {
  if (setup.graphics != Graphics::kUsual) return setup.graphics;
  return options.draws ? Graphics::kVirgl : Graphics::kVirtio;
}

int WidthOf(const QemuOptions& options, const Setup& setup) {
  return setup.width_px > 0 ? setup.width_px : options.width_px;
}

int HeightOf(const QemuOptions& options, const Setup& setup) {
  return setup.height_px > 0 ? setup.height_px : options.height_px;
}

const std::string& ImageOf(const QemuOptions& options, const Setup& setup) {
  return setup.image.empty() ? options.image : setup.image;
}

std::string SoundPath(const QemuOptions& options) {
  return options.folder + "/loudspeaker.wav";
}

std::string ScreenPath(const QemuOptions& options, int head) {
  return fmt::format("{}/screen{}.vnc", options.folder, head);
}

std::string LinesPath(const QemuOptions& options) {
  return options.folder + "/lines";
}

std::string ConsolePath(const QemuOptions& options) {
  return options.folder + "/console.log";
}

std::string LoggedCommandLine(const QemuOptions& options, const std::string& of_the_image) {
  constexpr std::string_view kQuiet = " quiet loglevel=3";
  std::string line = of_the_image;
  // "quiet" would hide what the log is wanted for.
  if (const std::size_t at = line.find(kQuiet); at != std::string::npos) line.erase(at, kQuiet.size());
  return fmt::format(
      "{} console={} loglevel={} systemd.log_target=console systemd.journald.forward_to_console=1 "
      "systemd.show_status=1",
      line, PlatformOf(options.architecture).serial, options.log_level);
}

Result<std::string> ReadCommandLine(const std::string& image) {
  return ReadFile(image + "/cmdline").map([](const std::string& text) {
    return text.substr(0, text.find('\n'));
  });
}

std::string BenchDisk(const Setup& setup) {
  return setup.disk_bus == DiskBus::kVirtio ? "/dev/vdb" : "/dev/vda";
}

std::string OnUsb(std::string line) {
  constexpr std::string_view kNone = "usbcore.authorized_default=0";
  if (const std::size_t at = line.find(kNone); at != std::string::npos) line[at + kNone.size() - 1] = '1';
  return line;
}

std::string BenchCommandLine(const std::string& of_the_image, const std::string& bench_disk) {
  const auto or_else = [&](const std::string& name, const std::string& otherwise) {
    // The last word counts, as it does for the kernel.
    const std::string value = WordOf(of_the_image, name);
    return value.empty() ? otherwise : value;
  };
  return fmt::format(
      "{} kaori.root={} kaori.rootfstype={} kaori.init={} root={} rootfstype=ext4 "
      "init=/usr/bin/kaori-hil-agent "
      "console=null",
      of_the_image, or_else("root", "/dev/dm-0"), or_else("rootfstype", "erofs"),
      or_else("init", "/usr/lib/systemd/systemd"), bench_disk);
}

std::vector<std::string> QemuCommand(const QemuOptions& options, const Setup& setup,
                                     const std::string& command_line, const std::string& disk) {
  const Platform& platform = PlatformOf(options.architecture);
  // Secure Boot wants system management mode.
  const std::string machine = std::string(platform.machine) + (setup.secure_boot ? ",smm=on" : "");
  // The name shows in its threads.
  std::vector<std::string> command{std::string(platform.qemu), "-M", machine, "-name",
                                   "box,debug-threads=on"};
  Add(command, {"-no-reboot", "-vga", "none", "-net", "none"});
  AddProcessors(options, setup, command);
  AddKernel(options, setup, command_line, command);
  AddDisk(options, setup, disk, command);
  AddScreens(options, setup, command);
  Add(command, {"-qmp", fmt::format("unix:{}/qmp,server=on,wait=off", options.folder)});
  AddWatchdog(options, setup, command);
  if (!setup.agent) {
    Add(command, {"-serial", "file:" + ConsolePath(options)});
    if (setup.plugged)
      AddUsb(options, setup, command);
    else
      Add(command, {"-device", "qemu-xhci"});
    return command;
  }
  Add(command,
      {"-drive", fmt::format("file={},if=none,id=bench,format=raw,readonly=on", options.bench_disk)});
  Add(command, {"-device", "virtio-blk-pci,drive=bench"});  // BenchDisk says its name in the machine.
  Add(command, {"-serial", fmt::format("unix:{}/serial,server=on,wait=off", options.folder)});
  AddLines(options, command);
  AddUsb(options, setup, command);
  AddNetworkCard(setup, command);
  AddSound(options, setup, command);
  return command;
}

}  // namespace kaori::hil
