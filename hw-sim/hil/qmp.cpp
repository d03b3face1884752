#include "hw-sim/hil/qmp.h"

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace kaori::hil {
namespace {

constexpr Duration kQmpLongest = std::chrono::seconds(60);  // An emulated machine on a busy computer is slow.
constexpr const char* kWhom = "QEMU";

}  // namespace

// QEMU greets with its version in one line of JSON, which is read and not looked at.
Result<Qmp> Qmp::Call(const std::string& path, Waiter& waiter) {
  auto stream = Stream::Call(path, waiter, kQmpLongest);
  if (!stream) return tl::unexpected(stream.error());
  Qmp qmp(std::move(*stream), waiter);
  if (auto greeting = qmp.stream_.NextLine(waiter, kQmpLongest, kWhom); !greeting)
    return tl::unexpected(greeting.error());
  // Before this command QEMU accepts no other.
  if (auto ok = qmp.Do("qmp_capabilities"); !ok) return tl::unexpected(ok.error());
  return qmp;
}

Result<void> Qmp::Do(const std::string& command, json::Object arguments) {
  const auto answer = Ask(command, std::move(arguments));
  return answer ? Result<void>{} : tl::unexpected(answer.error());
}

// QEMU lists an object's properties, of which those with a type "child<...>" are objects themselves.
Result<std::string> Qmp::ChildOfType(const std::string& path, const std::string& type) {
  auto answer = Ask("qom-list", {{"path", path}});
  if (!answer) return answer;
  const auto listed = nlohmann::json::parse(*answer, nullptr, false);
  for (const auto& property : listed["return"])
    if (property.value("type", "") == "child<" + type + ">") return path + '/' + property.value("name", "");
  return Fail(std::errc::no_such_device, fmt::format("find a {} in the machine", type));
}

// One command at a time, so that answers need no number.
Result<std::string> Qmp::Ask(const std::string& command, json::Object arguments) {
  const json::Object asked{{"execute", command}, {"arguments", std::move(arguments)}};
  if (auto ok = stream_.Say(json::Write(asked) + "\n"); !ok) return tl::unexpected(ok.error());
  while (true) {  // Between command and answer events may come.
    auto line = stream_.NextLine(*waiter_, kQmpLongest, kWhom);
    if (!line) return line;
    // The parser is told not to throw: text that is no JSON gives a value that contains nothing.
    const auto answer = nlohmann::json::parse(*line, nullptr, false);
    // An event has neither, and is passed over. What is no JSON is as well.
    if (answer.contains("return")) return line;
    if (answer.contains("error"))
      return Fail(std::errc::invalid_argument, command + ": " + answer["error"].value("desc", "refused"));
  }
}

}  // namespace kaori::hil
