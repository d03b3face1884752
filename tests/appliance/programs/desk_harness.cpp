// An operator with green lips, the lips and the desk in one process: the harness of the browser tests.
// Usage: desk-harness FOLDER [--plain]
// kaori-shows may listen at FOLDER/report/desk. Prints "address URL", "code 123456" for each new code. Reads lines:
//   mouth HEIGHT WIDTH    paint R G B (0 .. 1)    lips off | on    camera off | on

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "appliance/core/board/board.h"
#include "appliance/programs/desk/certificate.h"
#include "appliance/programs/desk/desk.h"
#include "appliance/programs/lips/service/lip_service.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "tests/appliance/programs/desk_operator.h"

namespace kaori::tests {
namespace {

constexpr Duration kStep = std::chrono::milliseconds(10);

void Say(const std::string& line) {
  std::puts(line.c_str());
  std::fflush(stdout);
}

// The operator, and the lips that watch.
class Operator {
 public:
  Operator(const std::string& folder, const board::Board& board) : folder_(folder), board_(board) {
    hand_.scene.person.paint = {0.05F, 0.62F, 0.2F};
    SetLips(true);
  }

  void SetLips(bool on) {
    service_.reset();
    reader_.reset();
    if (!on) return;
    const std::string file = folder_ + "/lips.settings";
    const lips::LipSettings settings = lips::SettingsFrom(file);
    reader_.emplace(OperatorCamera::Opener(hand_, clock_), board_,
                    board_.AcquireWriter<board::Lips>().value(), settings, clock_);
    service_ =
        lips::LipService::Open({.service = true, .file = file, .now = settings}, *reader_, board_, clock_)
            .value();
  }

  void Step() {
    if (reader_) reader_->Step();
    if (service_) service_->Step();
  }

  void Handle(const std::string& line) {
    std::istringstream stream(line);
    std::string what, value;
    stream >> what;
    auto& person = hand_.scene.person;
    if (what == "mouth") stream >> person.mouth.height >> person.mouth.width;
    if (what == "paint") stream >> person.paint.red >> person.paint.green >> person.paint.blue;
    if (what == "lips" && stream >> value) SetLips(value == "on");
    if (what == "camera" && stream >> value) hand_.plugged = value == "on";
  }

 private:
  std::string folder_;
  const board::Board& board_;
  SteadyClock clock_;
  OperatorHand hand_;
  std::optional<lips::LipReader> reader_;
  std::unique_ptr<lips::LipService> service_;
};

// Reads the test's commands, line by line.
class Commands {
 public:
  // Reads what waits on standard input. Returns false at its end.
  bool Read(Operator& person) {
    std::array<char, 256> text;
    const ssize_t got = ::read(STDIN_FILENO, text.data(), text.size());
    if (got <= 0) return false;
    received_.append(text.data(), static_cast<std::size_t>(got));
    for (auto end = received_.find('\n'); end != std::string::npos; end = received_.find('\n')) {
      person.Handle(received_.substr(0, end));
      received_.erase(0, end + 1);
    }
    return true;
  }

 private:
  std::string received_;
};

Result<desk::DeskOptions> OptionsOf(const std::string& folder, bool plain) {
  desk::DeskOptions options{
      .port = 0, .reach = web::Reach::kThisMachine, .shows = folder + "/report/desk", .brought = folder};
  if (plain) return options;
  const auto own = desk::LoadOrMakeCertificate(folder, {desk::OwnNames(), 0x7F000001U, std::time(nullptr)});
  if (!own) return tl::unexpected(own.error());
  options.certificate = own->pem;
  return options;
}

Result<void> Play(const std::string& folder, bool plain) {
  const SteadyClock clock;
  auto loop = EventLoop::Open();
  if (!loop) return tl::unexpected(loop.error());
  const auto board = board::Board::Create(folder + "/board");
  if (!board) return tl::unexpected(board.error());
  auto options = OptionsOf(folder, plain);
  if (!options) return tl::unexpected(options.error());
  Operator person(folder, *board);
  const auto desk = desk::Desk::Open(std::move(*options), *board, *loop, clock);
  if (!desk) return tl::unexpected(desk.error());
  Say("address " + (*desk)->address());
  std::uint32_t told = 1'000'000;  // No code.
  auto ok = loop->Every(kStep, [&] {
    person.Step();
    (*desk)->Step();
    const std::uint32_t code = (*desk)->pairing().code();
    if (std::exchange(told, code) != code) Say(fmt::format("code {:06}", code));
  });
  if (!ok) return ok;
  Commands commands;
  ok = loop->Watch(STDIN_FILENO, [&] {
    if (!commands.Read(person)) loop->Stop();
  });
  return ok ? loop->Run() : ok;
}

}  // namespace
}  // namespace kaori::tests

int main(int argc, char** argv) {
  kaori::SetLogName("desk-harness");
  if (argc < 2) {
    kaori::Log("usage: desk-harness FOLDER [--plain]");
    return EXIT_FAILURE;
  }
  if (auto played = kaori::tests::Play(argv[1], argc > 2); !played) {
    kaori::Log("{}", played.error().message());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
