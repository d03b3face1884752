// kaori-fdkeeper: keeps the graphics card's file open while no stage runs, so that the last picture stays on
// the screen: the kernel clears a screen when the last file of its card is closed.
//
// One thread. It holds the descriptor and nothing else, does not look at the card, and has no rights but its
// socket. Should it end too, the service manager still has the descriptor (FDSTORE=1 of sd_notify) and gives
// it back at the next start.
#include "drivers/base/event_loop.h"
#include "drivers/base/fd_keeper.h"
#include "drivers/base/log.h"
#include "drivers/base/loop_watchdog.h"
#include "drivers/base/options.h"
#include "drivers/base/packet_socket.h"
#include "drivers/base/program.h"
#include "drivers/base/service.h"

namespace {

constexpr std::string_view kHelp = R"(kaori-fdkeeper: keeps the graphics card open while no stage runs

  --socket PATH   the socket at which it listens; not given where the service manager passes one
)";

// The names of the descriptors in the service manager's store, which outlives this program too, and of its
// socket. The latter is FileDescriptorName= of the socket's unit.
constexpr const char* kHeld = "card";
constexpr const char* kPassed = "fdkeeper";

// The socket of --socket, else the one that systemd has opened and passes on; it outlives the program, so
// that a stage never finds it missing.
// Errors: those of ListenForPackets; invalid_argument where there is neither an option nor a passed socket.
kaori::Result<kaori::UniqueFd> Listener(const std::string& path) {
  if (!path.empty()) return kaori::ListenForPackets(path);
  if (auto passed = kaori::service::RetrieveFd(kPassed)) return std::move(*passed);
  return kaori::FailInput("no socket to listen at: give --socket");
}

}  // namespace

// FdKeeper (drivers/base/fd_keeper.h) has the protocol: a stage asks for the card, and gives it away.
int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-fdkeeper");
  std::string socket;
  kaori::Options options(kHelp);
  options.Text("--socket", socket);
  if (const auto status = options.Parse(argc, argv)) return *status;
  auto loop = kaori::EventLoop::Open();
  if (!loop) return kaori::ExitWithError(loop.error());
  auto listener = Listener(socket);
  if (!listener) return kaori::ExitWithError(listener.error());
  // The manager keeps the card's file even when this program ends, and gives it back at the next start.
  const auto keep = [](int fd) {
    if (auto kept = kaori::service::StoreFd(fd, kHeld); !kept)
      kaori::LogWarning("{}", kept.error().message());
  };
  kaori::service::FdKeeper keeper(*loop, std::move(*listener), kaori::service::RetrieveFd(kHeld), keep);
  if (auto open = keeper.Open(); !open) return kaori::ExitWithError(open.error());
  if (auto told = kaori::service::Tell("READY=1"); !told) kaori::LogWarning("{}", told.error().message());
  if (auto ok = kaori::service::FeedWatchdogOfUnit(*loop); !ok) return kaori::ExitWithError(ok.error());
  if (auto held = loop->Run(); !held) return kaori::ExitWithError(held.error());
  return 0;
}
