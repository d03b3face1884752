#include "tests/hil/agent/first_program.h"

#include <fcntl.h>
#include <sys/mount.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

namespace kaori::agent {
namespace {

constexpr const char* kBox = "/box";
constexpr const char* kBoxDevices = "/box/dev";

// The machine has no console: nothing is open yet, and the next file would be taken for standard input.
void OpenStandardFiles() {
  int fd = ::open("/dev/null", O_RDWR);
  while (fd >= 0 && fd < 2) fd = ::dup(fd);
}

Result<void> Mount(const std::string& what, const char* where, const std::string& type,
                   unsigned long flags = 0) {
  if (::mount(what.c_str(), where, type.c_str(), flags, nullptr) == 0 || errno == EBUSY) return {};
  return FailErrno("mount " + what + " on " + where);
}

Result<std::string> MountOwn() {
  for (const auto& [type, where] :
       {std::pair{"devtmpfs", "/dev"}, {"proc", "/proc"}, {"sysfs", "/sys"}, {"tmpfs", "/tmp"}})
    if (auto ok = Mount(type, where, type); !ok) return tl::unexpected(ok.error());
  static_cast<void>(Mount("configfs", "/sys/kernel/config", "configfs"));  // Where the kernel has it.
  std::ifstream file("/proc/cmdline");
  std::string line;
  std::getline(file, line);
  return line;
}

// As a ramdisk's first program does it: the new root is moved over the old one.
[[noreturn]] void BecomeTheBox(const std::string& init) {
  if (::chdir(kBox) == 0 && ::mount(".", "/", nullptr, MS_MOVE, nullptr) == 0 && ::chroot(".") == 0 &&
      ::chdir("/") == 0)
    ::execl(init.c_str(), init.c_str(), nullptr);
  ::_exit(1);  // The kernel says that its first program is gone, and restarts.
}

}  // namespace

std::string OnCommandLine(const std::string& command_line, const std::string& name) {
  std::istringstream words(command_line);
  for (std::string word; words >> word;)
    if (word.starts_with(name + "=")) return word.substr(name.size() + 1);
  return {};
}

Result<Roots> StartTheBox() {
  OpenStandardFiles();
  const auto line = MountOwn();
  if (!line) return tl::unexpected(line.error());
  const std::string root = OnCommandLine(*line, "kaori.root");
  if (auto ok = Mount(root, kBox, OnCommandLine(*line, "kaori.rootfstype"), MS_RDONLY); !ok)
    return tl::unexpected(ok.error());
  // What the kernel does for the first program of a root that it mounts itself.
  if (auto ok = Mount("devtmpfs", kBoxDevices, "devtmpfs"); !ok) return tl::unexpected(ok.error());
  Roots roots{UniqueFd(::open(kBox, O_PATH | O_DIRECTORY | O_CLOEXEC)),
              UniqueFd(::open("/", O_PATH | O_DIRECTORY | O_CLOEXEC))};
  if (!roots.box.valid() || !roots.bench.valid()) return FailErrno("open the roots");
  const pid_t agent = ::fork();
  if (agent < 0) return FailErrno("fork");
  if (agent > 0) BecomeTheBox(OnCommandLine(*line, "kaori.init"));
  ::setsid();
  return roots;
}

}  // namespace kaori::agent
