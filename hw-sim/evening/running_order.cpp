#include "hw-sim/evening/running_order.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "hw-sim/scenario/reader.h"

namespace kaori::sim {
namespace {

using What = Incident::Kind;

// The bound of 4 MiB keeps a wrong path, such as that of a picture, from being read as an order.
constexpr std::size_t kMostOrder_bytes = std::size_t{4} << 20U;
// A packet of a full-speed interrupt endpoint has 64 bytes at most (USB 2.0, 5.7.3).
constexpr int kMostBytesOfReport = 64, kMostCallsAtOnce = 200;

// Of a line that is no scenario's.
struct OrderLine {
  Duration at{};
  int number = 0;
  std::string_view text;
};

constexpr std::pair<std::string_view, Program> kPrograms[] = {
    {"stage", Program::kStage}, {"input", Program::kInput}, {"lips", Program::kLips}};
constexpr std::pair<std::string_view, What> kOfTheBoard[] = {
    {"remove", What::kBoardRemove}, {"cut", What::kBoardCut}, {"overwrite", What::kBoardOverwrite}};
constexpr std::pair<std::string_view, What> kOfTheDisk[] = {{"fill", What::kDiskFill},
                                                            {"free", What::kDiskFree}};

// The value of the next word among a few; else a problem that lists them.
template <class Value, std::size_t count>
Value OneOf(Tokenizer& tokens, const std::pair<std::string_view, Value> (&words)[count]) {
  std::string known;
  for (const auto& [word, value] : words) {
    if (tokens.Accept(word)) return value;
    known += (known.empty() ? "" : ", ") + std::string(word);
  }
  tokens.Complain(tokens.next_column(), "expected one of " + known);
  return {};
}

int WholeNumberOf(Tokenizer& tokens, std::string_view what, int most) {
  return static_cast<int>(tokens.Number(what, 1, most).value_or(1));
}

// The device whose report is spoilt.
// All other devices send no HID reports that could be torn.
DevicePort HidPortOf(Tokenizer& tokens) {
  const auto name = tokens.Next("the name of a device");
  if (!name) return {};
  const auto port = DevicePortNamed(name->text);
  constexpr std::array kHid{DevicePort::kDialBox, DevicePort::kStickLeft, DevicePort::kStickRight,
                            DevicePort::kKeyboard, DevicePort::kPointer};
  if (port && std::ranges::find(kHid, *port) != kHid.end()) return *port;
  tokens.Complain(name->column, fmt::format("no HID device is called \"{}\"", name->text));
  return {};
}

// The words are not checked here: the page's own reader does that when the call is made.
void ReadCallWords(Tokenizer& tokens, Incident& into) {
  while (!tokens.AtEnd())
    if (const auto word = tokens.Next("a call"))
      into.words += (into.words.empty() ? "" : " ") + std::string(word->text);
  if (into.words.empty()) tokens.Complain(tokens.next_column(), "expected a call, such as goto 14");
}

// One word, and what it makes of the rest of the line.
bool ReadIncident(Tokenizer& tokens, std::string_view word, Incident& into) {
  if (word == "call") {
    into.kind = What::kCall;
    ReadCallWords(tokens, into);
  } else if (word == "flood") {
    into.kind = What::kFlood;
    into.count = WholeNumberOf(tokens, "a number of calls", kMostCallsAtOnce);
  } else if (word == "tear" || word == "garbage") {
    into.kind = word == "tear" ? What::kTear : What::kGarbage;
    into.port = HidPortOf(tokens);
    into.count = WholeNumberOf(tokens, "a number of bytes", kMostBytesOfReport);
  } else if (word == "end" || word == "start") {
    into.kind = word == "end" ? What::kEnd : What::kStart;
    into.program = OneOf(tokens, kPrograms);
  } else if (word == "board") {
    into.kind = OneOf(tokens, kOfTheBoard);
  } else if (word == "disk") {
    into.kind = OneOf(tokens, kOfTheDisk);
  } else if (word == "freeze") {
    into.kind = What::kFreeze;
    into.length = tokens.TimeSpan().value_or(Duration{});
  } else {
    return false;
  }
  return true;
}

// What stands between two words of a line, as it was written.
std::string WordsBetween(std::string_view line, std::string_view first, std::string_view last) {
  line.remove_prefix(std::min(line.size(), line.find(first) + first.size()));
  line = line.substr(0, line.rfind(last));
  while (line.ends_with(' ')) line.remove_suffix(1);
  return std::string(line);
}

// Reads line by line and keeps what was read so far. Borrows the show; used for one text.
class OrderScript {
 public:
  explicit OrderScript(const show::Show& show) : show_(show) {}

  // Lines of the scenario are kept where they stand, and others become empty ones there: its reader counts
  // lines too.
  void ReadLine(std::string_view line, int number) {
    if (!ReadOwn(line, number)) scenario_ += line;
    scenario_ += '\n';
  }

  RunningOrderRead Finish() {
    Reading reading = ReadScenario(scenario_);
    read_.order.play = std::move(reading.scenario);
    read_.problems.insert(read_.problems.end(), reading.problems.begin(), reading.problems.end());
    // The sort is stable, so that several problems of one line stay in the order of its columns.
    std::ranges::stable_sort(read_.problems, {}, &Problem::line);
    RunningOrder& order = read_.order;
    std::ranges::stable_sort(order.incidents, {}, &Incident::at);
    std::ranges::stable_sort(order.expectations, {}, &Expectation::at);
    // The evening lasts until the last expectation has had its time and the last freeze is over.
    order.length = order.play.length;
    for (const Expectation& one : order.expectations)
      order.length = std::max(order.length, one.at + one.time);
    for (const Incident& one : order.incidents) order.length = std::max(order.length, one.at + one.length);
    return std::move(read_);
  }

 private:
  // False where the line is the scenario's. Its words are looked at with problems of their own: the
  // scenario's reader tells of those.
  bool ReadOwn(std::string_view line, int number) {
    std::vector<Problem> unused;
    Tokenizer look(line, number, unused);
    const bool timed = look.Accept("at") && look.TimeSpan();
    const auto word = look.AtEnd() ? std::nullopt : look.Next("");
    if (!word) return false;
    // A scene of the scenario ends the fault, but its line still belongs to the scenario's reader.
    if (word->text == "scene") fault_ = kNoFault;
    Incident incident;
    std::vector<Problem> trial;
    Tokenizer again(line, number, trial);
    again.Accept("at");
    if (timed) incident.at = again.TimeSpan().value_or(Duration{});
    again.Next("");
    // The line is read a second time, from its beginning, for its own statement.
    const std::size_t before = trial.size();
    const bool own = ReadStatementOf(again, word->text, {incident.at, number, line}, incident);
    if (!own) return false;
    if (!timed) again.Complain(1, "when? A line begins with its time, such as at 2.5s");
    if (!again.AtEnd()) again.Complain(again.next_column(), "nothing more is expected in this line");
    if (trial.size() != before || again.bad())
      read_.problems.insert(read_.problems.end(), trial.begin(), trial.end());
    return true;
  }

  bool ReadStatementOf(Tokenizer& tokens, std::string_view word, OrderLine line, Incident& incident) {
    if (word == "fault") {
      ReadFault(tokens, line);
    } else if (word == "expect" || word == "keep") {
      ReadExpectation(tokens, word == "keep", line);
    } else if (ReadIncident(tokens, word, incident)) {
      incident.line = line.number;
      read_.order.incidents.push_back(std::move(incident));
    } else {
      return false;
    }
    return true;
  }

  // The expectations that follow in the file refer to the fault by its index.
  void ReadFault(Tokenizer& tokens, OrderLine line) {
    const auto name = tokens.Next("what goes wrong, in quotes");
    if (!name) return;
    fault_ = static_cast<int>(read_.order.faults.size());
    read_.order.faults.push_back({line.at, std::string(name->text), line.number});
  }

  void ReadExpectation(Tokenizer& tokens, bool keep, OrderLine line) {
    Expectation expectation{.at = line.at, .keep = keep, .condition = ReadCondition(tokens, show_)};
    const std::string_view word = keep ? "for" : "within";
    if (!tokens.Accept(word)) return tokens.Complain(tokens.next_column(), fmt::format("expected {}", word));
    const auto time = tokens.TimeSpan();
    if (time && *time == Duration{})
      return tokens.Complain(tokens.last_column(), "nothing is seen in no time");
    expectation.time = time.value_or(Duration{});
    expectation.condition.words = WordsBetween(line.text, keep ? "keep " : "expect ", word);
    expectation.line = line.number;
    expectation.fault = fault_;
    read_.order.expectations.push_back(std::move(expectation));
  }

  const show::Show& show_;
  RunningOrderRead read_;
  std::string scenario_;
  int fault_ = kNoFault;
};

}  // namespace

RunningOrderRead ReadRunningOrder(std::string_view text, const show::Show& show) {
  OrderScript script(show);
  int number = 1;
  while (!text.empty()) {
    const auto end = text.find('\n');
    script.ReadLine(text.substr(0, end), number++);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return script.Finish();
}

Result<RunningOrder> LoadRunningOrder(const std::string& path, const show::Show& show) {
  const auto text = ReadFile(path, {.most_bytes = kMostOrder_bytes});
  if (!text) return tl::unexpected(text.error());
  RunningOrderRead read = ReadRunningOrder(*text, show);
  if (!read.problems.empty()) return FailInput(Describe(read.problems, path));
  const RunningOrder& order = read.order;
  if (order.play.actions.empty() && order.incidents.empty() && order.expectations.empty())
    return FailInput(path + ": nothing is done in it, and nothing is expected");
  return std::move(read.order);
}

void Shorten(RunningOrder& order, Duration length) {
  // Faults are in the order of the file; those at its end are the late ones.
  const auto late = [length](const auto& one) { return one.at > length; };
  std::erase_if(order.play.actions, late);
  std::erase_if(order.play.beats, late);
  std::erase_if(order.incidents, late);
  std::erase_if(order.expectations, [length](const Expectation& one) { return one.at + one.time > length; });
  while (!order.faults.empty() && late(order.faults.back())) order.faults.pop_back();
  PutInOrder(order.play);
  order.length = length;
}

}  // namespace kaori::sim
