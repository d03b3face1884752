#include "hw-sim/bench/qemu.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "hw-sim/links/usbredir/usb_rig.h"

namespace kaori::bench {
namespace {

constexpr int kUsbPorts = 8;

// The value of the last word "name=value"; empty where there is none.
std::string WordOf(const std::string& line, const std::string& name) {
  std::istringstream words(line);
  std::string value;
  for (std::string word; words >> word;)
    if (word.starts_with(name + "=")) value = word.substr(name.size() + 1);
  return value;
}

void Add(std::vector<std::string>& command, std::initializer_list<std::string> words) {
  command.insert(command.end(), words);
}

void AddDevices(const QemuOptions& options, std::vector<std::string>& command) {
  Add(command, {"-device", fmt::format("qemu-xhci,id=xhci,p2={0},p3={0}", kUsbPorts)});
  for (std::size_t n = 0; n < sim::kUsbSockets.size(); ++n) {
    const std::string path = sim::UsbSocketPath(options.folder, sim::kUsbSockets[n]);
    Add(command, {"-chardev", fmt::format("socket,id=usb{},path={},server=on,wait=off", n, path)});
    Add(command, {"-device", fmt::format("usb-redir,chardev=usb{},bus=xhci.0,port={}", n, n + 1)});
  }
  Add(command,
      {"-audiodev", "none,id=sound", "-device", "ich9-intel-hda", "-device", "hda-duplex,audiodev=sound"});
}

// Ends with us, however we end.
[[noreturn]] void Become(const std::vector<std::string>& command, const std::string& log) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  ::dup2(file, STDOUT_FILENO);
  ::dup2(file, STDERR_FILENO);
  std::vector<char*> argv;
  for (const std::string& word : command) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  ::execvp(argv[0], argv.data());
  ::_exit(127);
}

}  // namespace

std::string BenchCommandLine(const std::string& of_the_image) {
  const auto or_else = [&](const std::string& name, const std::string& otherwise) {
    const std::string value = WordOf(of_the_image, name);
    return value.empty() ? otherwise : value;
  };
  return fmt::format(
      "{} kaori.root={} kaori.rootfstype={} kaori.init={} root=/dev/vdb rootfstype=ext4 "
      "init=/usr/bin/kaori-witness "
      "console=null",
      of_the_image, or_else("root", "/dev/dm-0"), or_else("rootfstype", "erofs"),
      or_else("init", "/usr/lib/systemd/systemd"));
}

// The guest draws by itself: with a newer processor's instructions emulation is many times slower.
std::vector<std::string> QemuCommand(const QemuOptions& options, const std::string& command_line) {
  std::vector<std::string> command{"qemu-system-x86_64",
                                   "-M",
                                   "q35",
                                   "-accel",
                                   "tcg,thread=multi",
                                   "-cpu",
                                   "Nehalem",
                                   "-smp",
                                   "2",
                                   "-no-reboot",
                                   "-vga",
                                   "none",
                                   "-display",
                                   "none"};
  Add(command, {"-m", std::to_string(options.memory_mib), "-kernel", options.image + "/bzImage", "-append",
                command_line});
  Add(command, {"-drive", fmt::format("file={}/kaori.disk,if=virtio,format=raw,snapshot=on", options.image)});
  Add(command, {"-drive", fmt::format("file={},if=virtio,format=raw,readonly=on", options.bench_disk)});
  Add(command, {"-device", fmt::format("virtio-gpu-pci,id=screens,max_outputs={},xres={},yres={}",
                                       options.heads, options.width_px, options.height_px)});
  Add(command, {"-serial", fmt::format("unix:{}/serial,server=on,wait=off", options.folder)});
  Add(command, {"-qmp", fmt::format("unix:{}/qmp,server=on,wait=off", options.folder)});
  AddDevices(options, command);
  return command;
}

Result<void> QemuDriver::On() {
  std::ifstream file(options_.image + "/cmdline");
  std::string line;
  if (!std::getline(file, line)) return FailErrno("read " + options_.image + "/cmdline");
  const auto command = QemuCommand(options_, BenchCommandLine(line));
  process_ = ::fork();
  if (process_ < 0) return FailErrno("fork");
  if (process_ == 0) Become(command, options_.folder + "/qemu.log");
  auto qmp = Qmp::Call(options_.folder + "/qmp", waiter_);
  if (!qmp) return tl::unexpected(qmp.error());
  qmp_.emplace(std::move(*qmp));
  return {};
}

void QemuDriver::Off() {
  qmp_.reset();
  if (process_ <= 0) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
  process_ = -1;
}

bool QemuDriver::runs() const {
  return process_ > 0 &&
         ::waitid(P_PID, static_cast<id_t>(process_), nullptr, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         ::kill(process_, 0) == 0;
}

Result<void> QemuDriver::Shoot(int head, const std::string& file) {
  if (!qmp_) return Fail(std::errc::no_such_device, "take a picture of the screen");
  return qmp_->Do(
      "screendump",
      fmt::format(R"({{"filename":"{}","format":"png","device":"screens","head":{}}})", file, head));
}

}  // namespace kaori::bench
