// kaori-hil-agent: runs in the guest beside the box's own programs and answers the bench.
//
// Questions, one a line, each behind its number and a space:
//   hello                        "kaori-hil-agent"
//   clock                        CLOCK_MONOTONIC in ns
//   board                        the board as JSON
//   events MS                    what changed on it meanwhile
//   read PATH                    a file of the box
//   write PATH TEXT              a line into a file of the box that is there
//   fill PATH                    a file of the box that takes all the room of its disk; its bytes
//   remove PATH                  takes a file of the box away
//   tool WORDS...                a program of the bench's disk
//   own WORDS...                 a program of the box; "bench:PATH" in its words is a file of the bench's disk
//   start WORDS...               the same, left running; its number
//   start-tool WORDS...          a program of the bench's disk, left running
//   said NUMBER                  by a program that was started, so far
//   end NUMBER                   ends it; what it said
//   usb                          its devices, and whether each is authorised
//   faults                       what the kernel's log has told of faults of its own since the last such question, a line each; at
//                                first since its start
//   voice PATH SECONDS           writes a voice as a WAV file of the bench's disk
//   processes NAME               their numbers
//   signal NAME NUMBER           to every process of that name
//   lines request CHIP IN,IN OUT,OUT GPIO lines, by the box's own driver
//   lines edges | levels         what they did since the last question; how they stand
//   lines drive N 0|1            output number N, driven soon after the answer
//   dials make                   eight dials on simulated GPIO lines; the name of their chip
//   dials turn US N,N,...        turns them by so many edges each, with a pause in microseconds after each edge
//   damaged-disks FIRST COUNT    mounts and reads so many damaged file systems, and writes to some, as DamagedDisks says
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "appliance/core/board/board.h"
#include "drivers/base/log.h"
#include "drivers/base/number.h"
#include "drivers/gpio/chip_lines.h"
#include "hw-sim/devices/voice_file.h"
#include "tests/hil/agent/actions.h"
#include "tests/hil/agent/board_json.h"
#include "tests/hil/agent/damaged_disks.h"
#include "tests/hil/agent/first_program.h"
#include "tests/hil/agent/kernel_log.h"
#include "tests/hil/agent/serial_line.h"
#include "tests/hil/agent/simulated_dials.h"
#include "tests/hil/agent/usb_view.h"

namespace {

using kaori::Result;
using Words = std::vector<std::string>;

// Of ARM's machines and of PCs. A PC has none of the first name; where the first is there, the second one leads nowhere.
constexpr std::array kLines{"/dev/ttyAMA0", "/dev/ttyS0"};
constexpr kaori::Duration kLongestTool = std::chrono::seconds(120);

Words Split(const std::string& text, char by) {
  Words words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, by);)
    if (!word.empty()) words.push_back(word);
  return words;
}

class Agent {
 public:
  explicit Agent(const kaori::agent::Roots& roots) : roots_(roots) {}

  Result<std::string> Answer(const std::string& question) {
    Words words = Split(question, ' ');
    if (words.empty()) return kaori::FailInput("an empty question");
    const std::string verb = words.front();
    words.erase(words.begin());
    NameBenchFiles(words);
    if (verb == "hello") return "kaori-hil-agent";
    if (verb == "clock") return std::to_string(clock_.now().time_since_epoch().count());
    if (verb == "voice" && words.size() == 2) return Voice(words);
    if (verb == "faults") return Faults();
    if (verb == "usb") return kaori::agent::UsbDevices("/sys/bus/usb/devices");
    if (verb == "tool") return kaori::agent::RunIn(roots_.bench.get(), words, kLongestTool);
    if (verb == "own") return kaori::agent::RunIn(roots_.box.get(), words, kLongestTool);
    if (verb == "start") return started_.Start(roots_.box.get(), words);
    if (verb == "start-tool") return started_.Start(roots_.bench.get(), words);
    if (verb == "said" && words.size() == 1) return started_.Said(words[0]);
    if (verb == "end" && words.size() == 1) return started_.End(words[0]);
    if (verb == "lines") return Lines(words);
    if (verb == "dials") return Dials(words);
    if (verb == "damaged-disks" && words.size() == 2) return TryDamagedDisks(words);
    if (verb == "board" || verb == "events") return Board(verb == "board" ? Words{} : words);
    if (verb == "read" && words.size() == 1) return kaori::agent::ReadIn(roots_.box.get(), words[0]);
    if (verb == "write" && words.size() == 2)
      return kaori::agent::WriteIn(roots_.box.get(), words[0], words[1]);
    if (verb == "fill" && words.size() == 1) return kaori::agent::FillBy(roots_.box.get(), words[0]);
    if (verb == "remove" && words.size() == 1) return kaori::agent::RemoveIn(roots_.box.get(), words[0]);
    if (verb == "processes" && words.size() == 1) return kaori::agent::ProcessesOf(words[0]);
    if (verb == "signal" && words.size() == 2) return kaori::agent::SignalAll(words[0], words[1]);
    return kaori::FailInput("not understood: " + question);
  }

 private:
  // The box's programs reach the bench's disk through this process only, whose root it is.
  static void NameBenchFiles(Words& words) {
    constexpr std::string_view kBench = "bench:";
    for (std::string& word : words)
      if (word.starts_with(kBench))
        word = fmt::format("/proc/{}/root{}", ::getpid(), word.substr(kBench.size()));
  }

  // Opened for each question: the file comes with the first program that plays.
  Result<std::string> Board(const Words& words) const {
    const auto board =
        kaori::board::Board::Open(fmt::format("/proc/self/fd/{}/run/kaori/board", roots_.box.get()));
    if (!board) return tl::unexpected(board.error());
    if (words.empty()) return kaori::agent::BoardAsJson(*board, clock_);
    return kaori::agent::WatchEvents(*board, clock_, std::chrono::milliseconds(std::atoi(words[0].c_str())));
  }

  // Opened with the first question: the records wait in the kernel.
  Result<std::string> Faults() {
    if (!kernel_) {
      auto opened = kaori::agent::KernelLog::Open(kaori::agent::KernelLog::From::kOldestRecord);
      if (!opened) return tl::unexpected(opened.error());
      kernel_.emplace(std::move(*opened));
    }
    return fmt::format("{}", fmt::join(kernel_->NewFaults(), "\n"));
  }

  static Result<std::string> Voice(const Words& words) {
    const auto said = kaori::sim::SayVowels(std::chrono::seconds(std::atoi(words[1].c_str())));
    return kaori::sim::WriteWav(words[0], said).map([] { return std::string(); });
  }

  Result<std::string> Lines(const Words& words) {
    if (words.size() >= 3 && words[0] == "request") return RequestLines(words);
    if (!lines_) return kaori::FailInput("no lines were requested");
    if (words.size() == 3 && words[0] == "drive")
      return lines_->Drive(static_cast<std::uint32_t>(std::atoi(words[1].c_str())), words[2] == "1").map([] {
        return std::string();
      });
    if (words.size() == 1 && words[0] == "levels")
      return lines_->Levels().map([](std::uint32_t levels) { return std::to_string(levels); });
    if (words.size() == 1 && words[0] == "edges") return Edges();
    return kaori::FailInput("lines request, edges, levels or drive");
  }

  Result<std::string> RequestLines(const Words& words) {
    kaori::gpio::Wiring wiring;
    for (const std::string& number : Split(words[2], ','))
      wiring.inputs.push_back({.offset = static_cast<std::uint32_t>(std::atoi(number.c_str()))});
    for (const std::string& number : words.size() > 3 ? Split(words[3], ',') : Words{})
      wiring.outputs.push_back(
          {.offset = static_cast<std::uint32_t>(std::atoi(number.c_str())), .active_low = false});
    lines_.reset();
    auto requested = kaori::gpio::OpenLines(words[1], wiring, clock_);
    if (!requested) return tl::unexpected(requested.error());
    lines_ = std::move(*requested);
    return std::string();
  }

  Result<std::string> Dials(const Words& words) {
    if (words.size() == 1 && words[0] == "make") {
      auto made = kaori::agent::SimulatedDials::Make();
      if (!made) return tl::unexpected(made.error());
      return dials_.emplace(std::move(*made)).name();
    }
    const Words numbers = words.size() == 3 ? Split(words[2], ',') : Words{};
    if (!dials_ || numbers.size() != kaori::agent::SimulatedDials::kDials)
      return kaori::FailInput("dials make, then dials turn US and a number for each");
    std::array<int, kaori::agent::SimulatedDials::kDials> edges{};
    for (std::size_t n = 0; n < edges.size(); ++n) edges[n] = std::atoi(numbers[n].c_str());
    return dials_->Turn(edges, std::atoi(words[1].c_str())).map([] { return std::string(); });
  }

  // The good file systems are made once: it takes seconds.
  Result<std::string> TryDamagedDisks(const Words& words) {
    const auto first = kaori::ParseNumber<std::uint64_t>(words[0]);
    const auto count = kaori::ParseNumber<std::uint64_t>(words[1]);
    if (!first || !count) return kaori::FailInput("damaged-disks FIRST COUNT");
    if (!damaged_) {
      auto made = kaori::agent::DamagedDisks::Make();
      if (!made) return tl::unexpected(made.error());
      damaged_.emplace(std::move(*made));
    }
    return damaged_->Try(*first, *count);
  }

  // "LINE 0|1 AT_NS", a line each.
  Result<std::string> Edges() {
    std::string told;
    while (true) {
      const auto edge = lines_->ReadEdge();
      if (!edge && edge.error().cause == std::errc::resource_unavailable_try_again) return told;
      if (!edge) return tl::unexpected(edge.error());
      told +=
          fmt::format("{} {} {}\n", edge->line, edge->active ? 1 : 0, edge->at.time_since_epoch().count());
    }
  }

  const kaori::agent::Roots& roots_;
  kaori::SteadyClock clock_;
  kaori::agent::Started started_;
  std::unique_ptr<kaori::ports::GpioLines> lines_;
  std::optional<kaori::agent::DamagedDisks> damaged_;
  std::optional<kaori::agent::KernelLog> kernel_;
  std::optional<kaori::agent::SimulatedDials> dials_;
};

}  // namespace

int main() {
  kaori::SetLogName("kaori-hil-agent");
  if (::getpid() != 1) {
    kaori::Log("is the first program of a machine on the bench; see kaori-bench");
    return 2;
  }
  const auto roots = kaori::agent::StartTheBox();
  auto line = kaori::agent::SerialLine::Open(::access(kLines[0], F_OK) == 0 ? kLines[0] : kLines[1]);
  if (!line) return 1;
  if (!roots) return line->Answer(0, tl::unexpected(roots.error())), 1;
  Agent agent(*roots);
  while (const auto question = line->Next()) line->Answer(question->number, agent.Answer(question->text));
  return 0;
}
