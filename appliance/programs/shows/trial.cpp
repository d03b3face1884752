#include "appliance/programs/shows/trial.h"

#include <fcntl.h>
#include <grp.h>
#include <linux/capability.h>
#include <poll.h>
#include <pwd.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>

#include "drivers/base/log.h"
#include "drivers/base/unique_fd.h"

extern char** environ;  // NOLINT: POSIX declares it so.

namespace kaori::shows {
namespace {

constexpr std::size_t kMostHeard_bytes = 1 << 16;
constexpr int kAsk_ms = 100;

// A child process whose standard error is read here.
struct Child {
  pid_t pid = -1;
  UniqueFd says;
};

// While it lives the process's real ids are those of the trial's user: a child that is spawned with
// POSIX_SPAWN_RESETIDS takes them for all of its ids when it starts its program, and has no right then; and a
// process of that user may be sent a signal. What this process may do is said by its other ids, which stay.
class LentIds {
 public:
  explicit LentIds(const std::optional<TrialUser>& user) : is_other_(user.has_value()) {
    if (user && (::setresgid(user->group, kSame, kSame) < 0 || ::setresuid(user->user, kSame, kSame) < 0))
      failed_ = errno;
  }
  ~LentIds() {
    if (is_other_ && (::setresuid(user_, kSame, kSame) < 0 || ::setresgid(group_, kSame, kSame) < 0))
      LogError("cannot take back this program's own user id: it keeps that of the trial's user");
  }
  LentIds(const LentIds&) = delete;
  LentIds& operator=(const LentIds&) = delete;
  // Of setresuid(2); 0: they are lent.
  int failed() const { return failed_; }

 private:
  static constexpr auto kSame = static_cast<uid_t>(-1);
  const uid_t user_ = ::getuid();
  const gid_t group_ = ::getgid();
  const bool is_other_;
  int failed_ = 0;
};

// Its standard output stays ours, and goes to the log as it does on a laptop. Errors: those of pipe2(2),
// setresuid(2) and posix_spawn(3).
Result<Child> Spawn(const std::string& program, const std::string& pack,
                    const std::optional<TrialUser>& user) {
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) < 0) return FailErrno("start " + program);
  Child child{.pid = -1, .says = UniqueFd(ends[0])};
  const UniqueFd its_end(ends[1]);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, its_end.get(), STDERR_FILENO);
  std::array<std::string, 3> words{program, "--rehearse", pack};
  std::array<char*, 4> arguments{words[0].data(), words[1].data(), words[2].data(), nullptr};
  // The loop of this program blocks SIGINT and SIGTERM; the child shall end by them.
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  sigset_t none;
  ::sigemptyset(&none);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setflags(&attributes,
                             static_cast<short>(POSIX_SPAWN_SETSIGMASK | (user ? POSIX_SPAWN_RESETIDS : 0)));
  int failed = 0;
  {
    const LentIds ids(user);
    failed = ids.failed();
    if (failed == 0)
      failed = ::posix_spawn(&child.pid, program.c_str(), &actions, &attributes, arguments.data(), environ);
  }
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return Fail(static_cast<std::errc>(failed), "start " + program);
  return child;
}

// A process of another user is sent a signal by that user alone, or with a right that this one has not.
void Signal(const Child& child, int signal, const std::optional<TrialUser>& user) {
  const LentIds ids(user);
  ::kill(child.pid, signal);
}

void Kill(const Child& child, const std::optional<TrialUser>& user) {
  Signal(child, SIGKILL, user);
  while (::waitpid(child.pid, nullptr, 0) < 0 && errno == EINTR) {
  }
}

// How long a child is listened to, and when it rests.
class Patience {
 public:
  Patience(const Child& child, const TrialTerms& terms)
      : child_(child), terms_(terms), asked_(SteadyClock().now()), until_(asked_ + terms.longest) {}

  // Stops the child or lets it go on, and says whether somebody still waits for it. To be called every kAsk_ms. Errors:
  // timed_out, operation_canceled.
  Result<void> Ask() {
    const Time now = SteadyClock().now();
    if (is_stopped_) until_ += now - asked_;
    asked_ = now;
    const bool may_work = !terms_.may_work || terms_.may_work();
    if (may_work == is_stopped_) Signal(child_, may_work ? SIGCONT : SIGSTOP, terms_.user);
    is_stopped_ = !may_work;
    if (now >= until_) return Fail(std::errc::timed_out, "rehearse the show");
    if (terms_.wanted && !terms_.wanted()) return Fail(std::errc::operation_canceled, "rehearse the show");
    return {};
  }

 private:
  const Child& child_;
  const TrialTerms& terms_;
  Time asked_;
  Time until_;
  bool is_stopped_ = false;
};

// Listens until the child closes its end, the time is over, or nobody wants to know any more. Errors:
// timed_out, operation_canceled.
Result<std::string> Listen(const UniqueFd& says, Patience& patience) {
  std::string heard;
  std::array<char, 4096> piece{};
  while (true) {
    if (auto ok = patience.Ask(); !ok) return tl::unexpected(ok.error());
    pollfd ready{.fd = says.get(), .events = POLLIN, .revents = 0};
    if (::poll(&ready, 1, kAsk_ms) <= 0) continue;
    const ssize_t got = ::read(says.get(), piece.data(), piece.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return heard;
    if (heard.size() < kMostHeard_bytes) heard.append(piece.data(), static_cast<std::size_t>(got));
  }
}

// The status of its end, waitpid(2)'s. A child that has closed its standard error may run on. Errors: as Ask;
// the child then runs on.
Result<int> AwaitEnd(pid_t pid, Patience& patience) {
  while (true) {
    int status = 0;
    if (::waitpid(pid, &status, WNOHANG) == pid) return status;
    if (auto ok = patience.Ask(); !ok) return tl::unexpected(ok.error());
    ::poll(nullptr, 0, kAsk_ms);
  }
}

// Programs of the box say why they end in their last line; what stands before is their log.
std::string LastLine(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const auto begin = text.rfind('\n');
  return begin == std::string::npos ? text : text.substr(begin + 1);
}

}  // namespace

// getpwnam(3) keeps its answer in the library's memory: this is the one thread that asks.
Result<TrialUser> FindUser(const std::string& name) {
  const passwd* user = ::getpwnam(name.c_str());
  if (user == nullptr) return FailInput("there is no user " + name);
  return TrialUser{user->pw_uid, user->pw_gid};
}

// A program of root's gets, when it is started, all rights of the bounding set (capabilities(7)); those that
// this process has already stay with it, so that it can drop them and mount all the same.
Result<void> KeepRightsToOurselves() {
  if (::prctl(PR_CAPBSET_READ, CAP_SETGID) == 1 && ::geteuid() == 0 && ::setgroups(0, nullptr) < 0)
    return FailErrno("leave the groups of root");
  for (const unsigned long right :
       {CAP_SYS_ADMIN, CAP_SETUID, CAP_SETGID, CAP_DAC_READ_SEARCH, CAP_SETPCAP}) {
    if (::prctl(PR_CAPBSET_READ, right) != 1) continue;
    if (::prctl(PR_CAPBSET_DROP, right) < 0 && ::geteuid() == 0)
      return FailErrno("take the right to mount from what is started");
  }
  return {};
}

void MakeTrialFolder(const std::filesystem::path& report) {
  namespace fs = std::filesystem;
  std::error_code none;
  fs::create_directories(report / "trial", none);
  fs::permissions(report / "trial", fs::perms::all | fs::perms::sticky_bit, none);
}

Result<void> TryPack(const std::string& stage, const std::filesystem::path& pack, const TrialTerms& terms) {
  auto child = Spawn(stage, pack.string(), terms.user);
  if (!child) return tl::unexpected(child.error());
  Patience patience(*child, terms);
  const auto heard = Listen(child->says, patience);
  const auto status = heard ? AwaitEnd(child->pid, patience) : tl::unexpected(heard.error());
  if (!status) {
    Kill(*child, terms.user);
    return tl::unexpected(status.error());
  }
  if (WIFSIGNALED(*status))
    return Fail(std::errc::interrupted,
                "rehearse the show: signal " + std::to_string(WTERMSIG(*status)) + " ended it");
  if (WEXITSTATUS(*status) != 0)
    return FailInput(heard->empty() ? "it cannot be rehearsed" : LastLine(*heard));
  return {};
}

}  // namespace kaori::shows
