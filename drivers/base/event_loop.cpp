#include "drivers/base/event_loop.h"

#include <signal.h>
#include <sys/epoll.h>
#include <sys/signalfd.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "drivers/base/timer.h"

namespace kaori {
namespace {

// More than the descriptors of any of our programs that are ready at
// once; what does not fit comes with the next wait.
constexpr std::size_t kEventsAtOnce = 16;

// Empties a non-blocking descriptor. A timer's read gives 8 bytes and then fails with EAGAIN.
void Drain(int fd) {
  std::array<char, 256> ignored;
  while (::read(fd, ignored.data(), ignored.size()) > 0) {
  }
}

}  // namespace

// Threads that are made later inherit the mask. One that was made before still receives the signals, and the
// program ends by them.
Result<EventLoop> EventLoop::Open() {
  UniqueFd epoll(::epoll_create1(EPOLL_CLOEXEC));
  if (!epoll.valid()) return FailErrno("create an epoll set");
  sigset_t stops;
  ::sigemptyset(&stops);
  ::sigaddset(&stops, SIGINT);
  ::sigaddset(&stops, SIGTERM);
  ::sigprocmask(SIG_BLOCK, &stops, nullptr);
  // A write to a pipe or a socket whose reader is gone fails with EPIPE then, as every caller expects.
  ::signal(SIGPIPE, SIG_IGN);
  UniqueFd signals(::signalfd(-1, &stops, SFD_NONBLOCK | SFD_CLOEXEC));
  if (!signals.valid()) return FailErrno("create a signal descriptor");
  EventLoop loop(std::move(epoll));
  const int fd = signals.get();
  loop.owned_.push_back(std::move(signals));
  // Without a handler Run() itself stops on the signal descriptor, which survives a move of the loop.
  if (auto ok = loop.Watch(fd, nullptr); !ok) return tl::unexpected(ok.error());
  return loop;
}

Result<void> EventLoop::Watch(int fd, Handler handler) {
  epoll_event event{};
  // EPOLLHUP and EPOLLERR are always reported. Level-triggered: a handler
  // that leaves something unread is called again.
  event.events = EPOLLIN;
  event.data.fd = fd;
  if (::epoll_ctl(epoll_.get(), EPOLL_CTL_ADD, fd, &event) < 0)
    return FailErrno("watch descriptor " + std::to_string(fd));
  watched_.push_back(std::make_unique<Watched>(Watched{fd, std::move(handler)}));
  return {};
}

// The handler may be the one that is running: it is kept until the end of the turn, and destroyed then.
void EventLoop::Forget(int fd) {
  const auto it = std::ranges::find(watched_, fd, [](const auto& w) { return w->fd; });
  if (it == watched_.end()) return;
  // The kernel removes a descriptor by itself only when its last copy
  // closes, and the fd keeper may have a copy.
  ::epoll_ctl(epoll_.get(), EPOLL_CTL_DEL, fd, nullptr);
  forgotten_.push_back(std::move(*it));
  watched_.erase(it);
}

Result<void> EventLoop::Every(Duration period, Handler handler) {
  auto timer = OpenTimer(period, period, "create a timer");
  if (!timer) return tl::unexpected(timer.error());
  const int fd = timer->get();
  owned_.push_back(std::move(*timer));
  return Watch(fd, [fd, handler = std::move(handler)] {
    Drain(fd);
    handler();
  });
}

Result<void> EventLoop::Run() {
  running_ = true;
  while (running_) {
    std::array<epoll_event, kEventsAtOnce> events;
    const int count = ::epoll_wait(epoll_.get(), events.data(), static_cast<int>(events.size()), -1);
    if (count < 0 && errno != EINTR) return FailErrno("wait for events");
    // Each event is looked up again by its number: an earlier handler of the same wait may have
    // forgotten it, and the pointer would dangle. A number that was closed and given out again within
    // one wait would get a call too many; every handler bears one, since no read blocks.
    for (int i = 0; i < count && running_; ++i) Dispatch(events[static_cast<std::size_t>(i)].data.fd);
    forgotten_.clear();
  }
  return {};
}

Result<void> EventLoop::RunEvery(Duration period, Handler handler) {
  return Every(period, std::move(handler)).and_then([this] { return Run(); });
}

void EventLoop::Dispatch(int fd) {
  const auto it = std::ranges::find(watched_, fd, [](const auto& w) { return w->fd; });
  if (it == watched_.end()) return;
  if (const Watched* watched = it->get(); watched->handler)
    watched->handler();
  else
    Stop();
}

}  // namespace kaori
