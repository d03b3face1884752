#include "tests/hil/agent/actions.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace kaori::agent {
namespace {

constexpr std::size_t kMostText = 64 * 1024;

// "NAME=VALUE", and no path.
bool IsVariable(const std::string& word) {
  return word.find('=') < word.find('/');
}

// The path as openat(2) takes it from a root folder.
const char* Below(const std::string& path) {
  const auto from = path.find_first_not_of('/');
  return path.c_str() + (from == std::string::npos ? 0 : from);
}

[[noreturn]] void Become(int root, const std::vector<std::string>& words, int output) {
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  ::setenv("PATH", "/usr/bin:/usr/sbin:/bin", 1);
  std::vector<char*> argv;
  for (const std::string& word : words)
    if (!argv.empty() || !IsVariable(word))
      argv.push_back(const_cast<char*>(word.c_str()));
    else
      ::putenv(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  if (argv[0] == nullptr) ::_exit(127);
  if (::fchdir(root) == 0 && ::chroot(".") == 0) ::execvp(argv[0], argv.data());
  ::_exit(127);
}

// What comes until the writer has closed its end, or the time is over.
std::string ReadAll(int fd, Time until) {
  std::string text;
  std::array<char, 4096> part;
  while (true) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - SteadyClock().now()).count();
    pollfd poll{fd, POLLIN, 0};
    if (left <= 0 || ::poll(&poll, 1, static_cast<int>(left)) <= 0) return text;
    const ssize_t got = ::read(fd, part.data(), part.size());
    if (got <= 0) return text;
    text.append(part.data(), static_cast<std::size_t>(got));
  }
}

bool IsNumber(const std::string& text) {
  return !text.empty() && std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c) != 0; });
}

}  // namespace

Result<std::string> RunIn(int root, const std::vector<std::string>& words, Duration longest) {
  if (words.empty()) return FailInput("no program is named");
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) < 0) return FailErrno("make a pipe");
  const UniqueFd reading(ends[0]);
  UniqueFd writing(ends[1]);
  const pid_t child = ::fork();
  if (child < 0) return FailErrno("fork");
  if (child == 0) Become(root, words, writing.get());
  writing.reset();
  const Time until = SteadyClock().now() + longest;
  std::string said = ReadAll(reading.get(), until);
  if (SteadyClock().now() >= until) ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (said.size() > kMostText) said.resize(kMostText);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return said;
  return FailInput(words[0] + " ended with " + std::to_string(WIFEXITED(status) ? WEXITSTATUS(status) : -1) +
                   "\n" + said);
}

Result<std::string> Started::Start(int root, const std::vector<std::string>& words) {
  if (words.empty()) return FailInput("no program is named");
  UniqueFd said(::memfd_create("said", MFD_CLOEXEC));
  if (!said.valid()) return FailErrno("make a file for the output of " + words[0]);
  const pid_t child = ::fork();
  if (child < 0) return FailErrno("fork");
  if (child == 0) Become(root, words, said.get());
  said_[child] = std::move(said);
  return std::to_string(child);
}

Result<std::string> Started::End(const std::string& number) {
  const auto child = said_.find(IsNumber(number) ? std::atoi(number.c_str()) : -1);
  if (child == said_.end()) return FailInput("nothing was started as " + number);
  ::kill(child->first, SIGTERM);
  ::waitpid(child->first, nullptr, 0);
  auto text = Said(number);
  said_.erase(child);
  return text;
}

Result<std::string> Started::Said(const std::string& number) const {
  const auto child = said_.find(IsNumber(number) ? std::atoi(number.c_str()) : -1);
  if (child == said_.end()) return FailInput("nothing was started as " + number);
  std::string text(kMostText, '\0');
  const ssize_t got = ::pread(child->second.get(), text.data(), text.size(), 0);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  return text;
}

Result<std::string> ReadIn(int root, const std::string& path) {
  const UniqueFd fd(::openat(root, Below(path), O_RDONLY | O_CLOEXEC));
  if (!fd.valid()) return FailErrno("open " + path);
  std::string text(kMostText, '\0');
  std::size_t bytes = 0;
  for (ssize_t got = 1; got > 0 && bytes < kMostText;
       bytes += static_cast<std::size_t>(std::max<ssize_t>(got, 0)))
    got = ::read(fd.get(), text.data() + bytes, kMostText - bytes);
  text.resize(bytes);
  return text;
}

Result<std::string> WriteIn(int root, const std::string& path, const std::string& text) {
  const UniqueFd fd(::openat(root, Below(path), O_WRONLY | O_CLOEXEC));
  if (!fd.valid()) return FailErrno("open " + path);
  const std::string line = text + "\n";
  if (::write(fd.get(), line.data(), line.size()) != static_cast<ssize_t>(line.size()))
    return FailErrno("write " + path);
  return std::string();
}

// Room is reserved and not written, which takes no time: in large pieces first, as a disk has them.
Result<std::string> FillBy(int root, const std::string& path) {
  constexpr off_t kLargest_bytes = off_t{1} << 30, kLeast_bytes = 1024;
  const UniqueFd fd(::openat(root, Below(path), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
  if (!fd.valid()) return FailErrno("make " + path);
  off_t filled = 0;
  for (off_t piece = kLargest_bytes; piece >= kLeast_bytes;) {
    if (::fallocate(fd.get(), 0, filled, piece) == 0)
      filled += piece;
    else if (errno == ENOSPC)
      piece /= 2;
    else
      return FailErrno("fill " + path);
  }
  return std::to_string(filled);
}

Result<std::string> RemoveIn(int root, const std::string& path) {
  if (::unlinkat(root, Below(path), 0) < 0) return FailErrno("remove " + path);
  return std::string();
}

std::string ProcessesOf(const std::string& name) {
  std::string numbers;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", error)) {
    const std::string process = entry.path().filename();
    if (!IsNumber(process)) continue;
    std::string comm;
    std::getline(std::ifstream(entry.path() / "comm"), comm);
    if (comm == name) numbers += (numbers.empty() ? "" : " ") + process;
  }
  return numbers;
}

Result<std::string> SignalAll(const std::string& name, const std::string& signal) {
  if (!IsNumber(signal)) return FailInput("a signal is a number, not " + signal);
  int found = 0;
  std::istringstream processes(ProcessesOf(name));
  for (pid_t process = 0; processes >> process;)
    if (::kill(process, std::atoi(signal.c_str())) == 0) ++found;
  return std::to_string(found);
}

}  // namespace kaori::agent
