#include "hw-sim/hil/qmp.h"

#include <utility>

#include <nlohmann/json.hpp>

namespace kaori::hil {
namespace {

constexpr Duration kQmpLongest = std::chrono::seconds(60);  // An emulated machine on a busy computer is slow.

}  // namespace

// QEMU greets with its version in one line of JSON, which is read and not looked at.
Result<Qmp> Qmp::Call(const std::string& path, Waiter& waiter) {
  auto stream = Stream::Call(path, waiter, kQmpLongest);
  if (!stream) return tl::unexpected(stream.error());
  Qmp qmp(std::move(*stream), waiter);
  if (auto greeting = qmp.NextLine(); !greeting) return tl::unexpected(greeting.error());
  // Before this command QEMU accepts no other.
  if (auto ok = qmp.Do("qmp_capabilities"); !ok) return tl::unexpected(ok.error());
  return qmp;
}

// Messages of QMP end with a newline and have none within. The line is returned without it.
Result<std::string> Qmp::NextLine() {
  bool there = true;
  // An end that has gone also ends the wait; a line that came before is still read.
  const auto whole = [&] {
    there = stream_.Read();
    return !there || stream_.waiting().find('\n') != std::string::npos;
  };
  if (!waiter_->Until(whole, kQmpLongest, stream_.pollable()))
    return Fail(std::errc::timed_out, "hear from QEMU");
  const std::size_t end = stream_.waiting().find('\n');
  if (end == std::string::npos) return Fail(std::errc::no_such_device, "hear from QEMU");
  std::string line = stream_.waiting().substr(0, end);
  stream_.Drop(end + 1);
  return line;
}

// One command at a time, so that answers need no number.
Result<void> Qmp::Do(const std::string& command, json::Object arguments) {
  const json::Object asked{{"execute", command}, {"arguments", std::move(arguments)}};
  if (auto ok = stream_.Say(json::Write(asked) + "\n"); !ok) return ok;
  while (true) {  // Between command and answer events may come.
    const auto line = NextLine();
    if (!line) return tl::unexpected(line.error());
    // The parser is told not to throw: text that is no JSON gives a value that contains nothing.
    const auto answer = nlohmann::json::parse(*line, nullptr, false);
    // An event has neither, and is passed over. What is no JSON is as well.
    if (answer.contains("return")) return {};
    if (answer.contains("error"))
      return Fail(std::errc::invalid_argument, command + ": " + answer["error"].value("desc", "refused"));
  }
}

}  // namespace kaori::hil
