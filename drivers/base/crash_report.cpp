#include "drivers/base/crash_report.h"

#include <dlfcn.h>
#include <elf.h>
#include <execinfo.h>
#include <link.h>
#include <poll.h>
#include <sys/prctl.h>
#include <ucontext.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include "drivers/base/clock.h"
#include "drivers/base/log.h"

namespace kaori {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitizersReport = true;
#else
constexpr bool kSanitizersReport = false;
#endif

constexpr std::array kSignals = {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGSYS, SIGABRT};
// So many bytes a pipe keeps together (PIPE_BUF).
constexpr std::size_t kReportBytes = 4096;
constexpr int kReportFrames = 24;
// The handler's own frames come before those of the report.
constexpr int kUnwoundFrames = kReportFrames + 8;
// A thread that crashes while another one reports waits for that one to end the process, and no longer.
constexpr int kReportWait_ms = 1000;
// An overflow of the first thread's stack leaves no room on it: the handler has its own.
constexpr std::size_t kHandlerStackBytes = 65536;

// Names of programs are shorter by far.
constexpr std::size_t kNameBytes = 64;

// Made when the program begins, and only read by the handler, which may take no lock and allocate nothing. Texts end
// with a zero; they are no strings, which would be gone where a program crashes on its way out of main.
struct Prepared {
  std::array<char, kNameBytes> prefix;
  std::array<char, kNameBytes> program;
  Time began;
};
Prepared prepared{};
std::array<char, kHandlerStackBytes> handler_stack;
// The thread that writes the report, 0 before; what is lock-free may be used in a handler.
std::atomic<pid_t> reporter{0};
static_assert(std::atomic<pid_t>::is_always_lock_free);

// A text of bounded size; what does not fit is left out. All of it is async-signal-safe.
class ReportText {
 public:
  ReportText& Add(std::string_view text) {
    const auto fits = std::min(text.size(), bytes_.size() - size_);
    std::memcpy(bytes_.data() + size_, text.data(), fits);
    size_ += fits;
    return *this;
  }

  // `digits` at least, with zeros before.
  ReportText& Number(std::uint64_t number, unsigned base, std::size_t digits = 1) {
    std::array<char, 24> text{};
    std::size_t first = text.size();
    for (; number > 0 || text.size() - first < digits; number /= base)
      text[--first] = "0123456789abcdef"[number % base];
    return Add({text.data() + first, text.size() - first});
  }

  ReportText& BeginLine() { return Add(prepared.prefix.data()); }

  // One write(2), of whole lines alone.
  void Write() const {
    const auto end = std::string_view(bytes_.data(), size_).rfind('\n');
    if (end == std::string_view::npos) return;
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, bytes_.data(), end + 1);
  }

 private:
  std::array<char, kReportBytes> bytes_;
  std::size_t size_ = 0;
};

// The identity in one segment of notes; empty where it has none. Names and contents are padded to 4 bytes.
std::span<const std::uint8_t> BuildIdIn(std::span<const std::uint8_t> notes) {
  const auto padded = [](std::size_t size) { return (size + 3) & ~std::size_t{3}; };
  while (notes.size() > sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) note;
    std::memcpy(&note, notes.data(), sizeof(note));
    const std::size_t content = sizeof(note) + padded(note.n_namesz);
    const std::size_t end = content + padded(note.n_descsz);
    if (end > notes.size()) return {};
    if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == sizeof(ELF_NOTE_GNU) &&
        std::memcmp(notes.data() + sizeof(note), ELF_NOTE_GNU, sizeof(ELF_NOTE_GNU)) == 0)
      return notes.subspan(content, note.n_descsz);
    notes = notes.subspan(end);
  }
  return {};
}

// The module's identity, which the linker put among its notes; they lie in memory, after the ELF header with which
// the first segment begins. Empty where the module has none.
std::span<const std::uint8_t> BuildIdOf(const dl_find_object& module) {
  const auto* const start = static_cast<const std::uint8_t*>(module.dlfo_map_start);
  ElfW(Ehdr) header;
  std::memcpy(&header, start, sizeof(header));
  if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0) return {};
  for (int i = 0; i < header.e_phnum; ++i) {
    ElfW(Phdr) segment;
    std::memcpy(&segment, start + header.e_phoff + sizeof(segment) * static_cast<unsigned>(i),
                sizeof(segment));
    if (segment.p_type != PT_NOTE) continue;
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the loader gives its address as a number.
    const auto* notes = reinterpret_cast<const std::uint8_t*>(module.dlfo_link_map->l_addr + segment.p_vaddr);
    if (const auto id = BuildIdIn({notes, segment.p_memsz}); !id.empty()) return id;
  }
  return {};
}

// The loader's own name of the program is empty.
std::string_view NameOf(const dl_find_object& module) {
  const std::string_view path = module.dlfo_link_map->l_name;
  return path.empty() ? std::string_view(prepared.program.data()) : path.substr(path.rfind('/') + 1);
}

// _dl_find_object(3) is async-signal-safe, which dladdr(3) and dl_iterate_phdr(3) are not.
void AddFrame(ReportText& text, unsigned number, void* address) {
  text.BeginLine().Add("#").Number(number, 10).Add(" ");
  dl_find_object module{};
  if (_dl_find_object(address, &module) != 0) {
    text.Add("?+0x0 -\n");
    return;
  }
  text.Add(NameOf(module)).Add("+0x");
  text.Number(reinterpret_cast<std::uintptr_t>(address) - module.dlfo_link_map->l_addr, 16).Add(" ");
  const auto id = BuildIdOf(module);
  for (const std::uint8_t byte : id) text.Number(byte, 16, 2);
  text.Add(id.empty() ? "-\n" : "\n");
}

// Where the signal came.
void* InstructionOf(const void* context) {
  const auto& machine = static_cast<const ucontext_t*>(context)->uc_mcontext;
#if defined(__x86_64__)
  const auto at = machine.gregs[REG_RIP];
#elif defined(__aarch64__)
  const auto at = machine.pc;
#else
#error "where does this processor keep the address of its instruction?"
#endif
  // NOLINTNEXTLINE(performance-no-int-to-ptr): the kernel gives it as a number.
  return reinterpret_cast<void*>(at);
}

// backtrace(3) took its library when the program began; since glibc 2.35 it takes no lock on its way either.
void AddFrames(ReportText& text, void* instruction) {
  std::array<void*, kUnwoundFrames> frames{};
  const int count = ::backtrace(frames.data(), kUnwoundFrames);
  const std::span all(frames.data(), static_cast<std::size_t>(std::max(count, 0)));
  // The handler's own frames come first. They stay where the instruction is none of a module, as after a call of a
  // null pointer: nothing is known of its callers then.
  const auto at = std::find(all.begin(), all.end(), instruction);
  const auto callers = at == all.end() ? all : all.subspan(static_cast<std::size_t>(at - all.begin()) + 1);
  unsigned number = 0;
  AddFrame(text, number++, instruction);
  for (void* caller : callers.first(std::min<std::size_t>(callers.size(), kReportFrames - 1)))
    AddFrame(text, number++, caller);
}

void WriteReport(int signal, void* instruction) {
  constexpr std::size_t kThreadNameBytes = 16;  // As prctl(2) has it, its terminating zero with it.
  std::array<char, kThreadNameBytes> thread{};
  ::prctl(PR_GET_NAME, thread.data());
  const auto lived =
      std::chrono::duration_cast<std::chrono::milliseconds>(SteadyClock().now() - prepared.began);
  const auto lived_ms = static_cast<std::uint64_t>(lived.count());
  ReportText text;
  text.BeginLine().Add("signal ").Number(static_cast<unsigned>(signal), 10).Add(" after ");
  text.Number(lived_ms / 1000, 10).Add(".").Number(lived_ms % 1000, 10, 3);
  text.Add(" s in thread ").Add(thread.data()).Add("\n");
  AddFrames(text, instruction);
  text.Write();
}

// Raised again, a signal waits until the handler has returned, since it is blocked meanwhile, and then does what it
// does without one. A fault within the handler comes back here by another signal, or the kernel ends the process.
void HandleCrash(int signal, siginfo_t* /*info*/, void* context) {
  const pid_t self = ::gettid();
  pid_t other = 0;
  if (reporter.compare_exchange_strong(other, self))
    WriteReport(signal, InstructionOf(context));
  else if (other != self)
    ::poll(nullptr, 0, kReportWait_ms);
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

}  // namespace

void ReportCrashes() {
  if (kSanitizersReport) return;
  std::error_code none;
  const std::string prefix = LogPrefix(Severity::kCrash) + "crash: ";
  const std::string program = std::filesystem::read_symlink("/proc/self/exe", none).filename();
  prepared = {};
  prefix.copy(prepared.prefix.data(), kNameBytes - 1);
  program.copy(prepared.program.data(), kNameBytes - 1);
  prepared.began = SteadyClock().now();
  // The first call loads the library that unwinds, which no handler may do.
  void* here = nullptr;
  ::backtrace(&here, 1);
  stack_t stack{};
  stack.ss_sp = handler_stack.data();
  stack.ss_size = handler_stack.size();
  // Neither can fail: the stack is large enough, and the signals can be caught.
  ::sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_sigaction = HandleCrash;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  for (const int signal : kSignals) ::sigaction(signal, &action, nullptr);
}

}  // namespace kaori
