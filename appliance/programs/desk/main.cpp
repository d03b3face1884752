// kaori-desk: serves the page on which the lips are calibrated and the box is set up, in the service profile only.
//
// One thread and one event loop, in which libmicrohttpd runs too. It runs in service only: in a show there is
// no page and no open port.
//
// It ends with status 2 where it is started without --service or misused, and with 1 where the port, the
// board or the certificate cannot be had. Lips that do not run are no error: the page says so, and the desk
// connects when they are there.
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>

#include "appliance/core/board/watch.h"
#include "appliance/programs/desk/certificate.h"
#include "appliance/programs/desk/desk.h"
#include "appliance/programs/shows/protocol/protocol.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "drivers/base/loop_watchdog.h"
#include "drivers/base/number.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"
#include "drivers/base/service.h"
#include "drivers/base/whole_file.h"

namespace {

using namespace std::chrono_literals;

constexpr std::string_view kHelp =
    R"(kaori-desk: serves the page on which the lips are calibrated and the box is set up, before and between shows

  --service            the box is in service; without this option the program ends at once
  --board FILE         the board, shared with the other programs
  --port PORT          the port of the page (8443); 0 uses any free one
  --data FOLDER        the folder of the certificate (/var/lib/kaori if it exists, else $XDG_STATE_HOME/kaori)
  --box SOCKET         where kaori-shows listens, whose list the page shows (/run/kaori-shows/desk)
  --open FILE          is there while the service key is on; the desk ends when it is gone (it serves until it is stopped)
  --plain              serve HTTP instead of HTTPS, for tests
  --local              serve this machine only, for tests
  --address-file FILE  write the page's address to this file
)";

// Shorter than the 60 ms between two states or two pictures, which are what a visitor sees move.
constexpr kaori::Duration kTick = 20ms;

struct Settings {
  std::string board = "/dev/shm/kaori-board", port = "8443", data, address_file, open,
              shows = kaori::shows::kDeskSocket;
  bool service = false, plain = false, local = false;
};

// On the box the data partition, on a developer's machine where such data belong (XDG base directories).
std::filesystem::path FolderOf(const Settings& settings) {
  if (!settings.data.empty()) return settings.data;
  std::error_code none;
  if (std::filesystem::is_directory("/var/lib/kaori", none)) return "/var/lib/kaori";
  if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr)
    return std::filesystem::path(state) / "kaori";
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home == nullptr ? "." : home) / ".local/state/kaori";
}

// The certificate is loaded, or made, before anything listens.
kaori::Result<kaori::desk::DeskOptions> OptionsOf(const Settings& settings) {
  kaori::desk::DeskOptions options;
  const auto port = kaori::ParseNumber<std::uint16_t>(settings.port);
  if (!port) return kaori::FailInput("--port " + settings.port + ": expected a number from 0 to 65535");
  options.port = *port;
  options.shows = settings.shows;
  options.brought = FolderOf(settings);
  if (settings.local) options.reach = kaori::web::Reach::kThisMachine;
  if (settings.plain) return options;
  const auto own = kaori::desk::LoadOrMakeCertificate(
      FolderOf(settings),
      {kaori::desk::OwnNames(), kaori::desk::OwnAddress(), static_cast<std::int64_t>(std::time(nullptr))});
  if (!own) return tl::unexpected(own.error());
  options.certificate = own->pem;
  options.fingerprint = own->fingerprint;
  return options;
}

// Errors: those of writing the file. A service manager that cannot be told is logged, and the desk serves all
// the same.
kaori::Result<void> AnnounceAddress(const std::string& file, const std::string& address) {
  kaori::Log("the desk is at {}; its code is on the box's screen", address);
  if (auto told = kaori::service::Tell("READY=1"); !told) kaori::LogWarning("{}", told.error().message());
  if (file.empty()) return {};
  return kaori::WriteWholeFile(file, {kaori::AsBytes(address + "\n")});
}

// The key's file lies in memory, so that asking for it at each step costs nothing.
bool KeyIsOff(const Settings& settings) {
  std::error_code none;
  return !settings.open.empty() && !std::filesystem::exists(settings.open, none);
}

// READY=1 is told, and the address written, only when the port is open: a test that finds the file can
// connect.
int Serve(const Settings& settings, kaori::EventLoop& loop) {
  auto options = OptionsOf(settings);
  if (!options) return kaori::ExitWithError(options.error());
  auto board = kaori::board::Board::Create(settings.board);
  if (!board) return kaori::ExitWithError(board.error());
  const kaori::SteadyClock clock;
  const auto desk = kaori::desk::Desk::Open(std::move(*options), *board, loop, clock);
  if (!desk) return kaori::ExitWithError(desk.error());
  if (auto told = AnnounceAddress(settings.address_file, (*desk)->address()); !told)
    return kaori::ExitWithError(told.error());
  if (auto ok = kaori::board::Watch(*board, loop); !ok) return kaori::ExitWithError(ok.error());
  if (auto ok = kaori::service::FeedWatchdogOfUnit(loop); !ok) return kaori::ExitWithError(ok.error());
  const auto step = [&] {
    if (KeyIsOff(settings)) return loop.Stop();
    (*desk)->Step();
  };
  if (auto ok = loop.RunEvery(kTick, step); !ok) return kaori::ExitWithError(ok.error());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-desk");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--board", settings.board).Text("--port", settings.port).Text("--data", settings.data);
  options.Text("--address-file", settings.address_file)
      .Text("--open", settings.open)
      .Text("--box", settings.shows)
      .Switch("--service", settings.service)
      .Switch("--plain", settings.plain)
      .Switch("--local", settings.local);
  if (const auto status = options.Parse(argc, argv)) return *status;
  if (!settings.service) {
    kaori::LogError("the desk runs only in service; give --service to start it");
    return 2;
  }
  auto loop = kaori::EventLoop::Open();
  if (!loop) return kaori::ExitWithError(loop.error());
  return Serve(settings, *loop);
}
