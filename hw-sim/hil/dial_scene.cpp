#include "hw-sim/hil/dial_scene.h"

#include <utility>

#include <fmt/format.h>

namespace kaori::hil {
namespace {

constexpr Duration kDialAnswer = std::chrono::seconds(120);
constexpr const char* kInputOfTheBox = "kaori-input.service";

}  // namespace

Result<std::string> AskOfDials(Scene& scene, const std::string& question) {
  return scene.target.agent().Ask(question, kDialAnswer);
}

StartedInput::StartedInput(Scene& scene, const std::string& options)
    : scene_(scene),
      unit_(scene, kInputOfTheBox),
      number_(
          AskOfDials(scene, "start /usr/bin/kaori-input --board /run/kaori/board " + options).value_or("")) {}

std::string StartedInput::End() {
  const std::string number = std::exchange(number_, {});
  return number.empty() ? std::string() : AskOfDials(scene_, "end " + number).value_or("");
}

Result<BoardView> WantBoard(Scene& scene, const std::function<bool(const BoardView&)>& right,
                            const std::string& what) {
  auto seen = scene.target.UntilBoard(right, kLongestDial, what);
  return seen ? seen : Result<BoardView>(FailInput(fmt::format("{} was not seen", what)));
}

}  // namespace kaori::hil
