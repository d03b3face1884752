// kaori-fdkeeper: holds the graphics card while no stage runs, so that the last picture stays on the screen.
#include "drivers/base/event_loop.h"
#include "drivers/base/fd_keeper.h"
#include "drivers/base/log.h"
#include "drivers/base/options.h"
#include "drivers/base/packet_socket.h"
#include "drivers/base/service.h"

namespace {

constexpr std::string_view kHelp = R"(kaori-fdkeeper: holds the graphics card while no stage runs

  --socket PATH   where the stage calls; none where the service manager listens for it
)";

constexpr const char* kHeld = "card";  // In the service manager's store: it outlives this program too.

int Complain(const kaori::Error& error) {
  kaori::Log("{}", error.message());
  return 1;
}

kaori::Result<kaori::UniqueFd> Listener(const std::string& path) {
  if (!path.empty()) return kaori::ListenForPackets(path);
  if (auto passed = kaori::service::RetrieveFd("holder")) return std::move(*passed);
  return kaori::FailInput("where to listen? Give --socket");
}

}  // namespace

int main(int argc, char** argv) {
  kaori::SetLogName("kaori-fdkeeper");
  std::string socket;
  kaori::Options options(kHelp);
  options.Text("--socket", socket);
  if (const auto status = options.Parse(argc, argv)) return *status;
  auto loop = kaori::EventLoop::Open();
  if (!loop) return Complain(loop.error());
  auto listener = Listener(socket);
  if (!listener) return Complain(listener.error());
  const auto keep = [](int fd) {
    if (auto kept = kaori::service::StoreFd(fd, kHeld); !kept) Complain(kept.error());
  };
  kaori::service::FdKeeper holder(*loop, std::move(*listener), kaori::service::RetrieveFd(kHeld), keep);
  if (auto open = holder.Open(); !open) return Complain(open.error());
  if (auto told = kaori::service::Tell("READY=1"); !told) Complain(told.error());
  if (auto held = loop->Run(); !held) return Complain(held.error());
  return 0;
}
