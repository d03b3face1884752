#include "hw-sim/monitor/stage_caller.h"

#include <algorithm>
#include <array>
#include <utility>

namespace kaori::sim {
namespace {

struct Word {
  std::string_view word;
  board::CallVerb verb;
};
constexpr std::array<Word, 2> kOfCues{
    {{"goto", board::CallVerb::kGoTo}, {"standby", board::CallVerb::kStandBy}}};

Result<board::Call> ReadCall(std::string_view line) {
  const auto space = line.find(' ');
  const std::string_view word = line.substr(0, space);
  const std::string_view rest = space == std::string_view::npos ? "" : line.substr(space + 1);
  const auto* const of_cue = std::ranges::find(kOfCues, word, &Word::word);
  if (of_cue == kOfCues.end())
    return FailInput("\"" + std::string(line) + "\" is no call: goto and standby are known");
  if (rest.empty() || rest.find_first_not_of("0123456789.") != std::string_view::npos)
    return FailInput("\"" + std::string(line) + "\": expected the number of a cue, as in goto 14");
  return board::Call{
      .verb = of_cue->verb, .subject = board::CueKey(rest), .source = board::CallSource::kPage};
}

}  // namespace

// The board is looked after at each call: a page calls seldom, and nothing else here needs it.
Result<void> StageCaller::Call(std::string_view line) {
  auto call = ReadCall(line);
  if (!call) return tl::unexpected(call.error());
  if (auto open = Open(); !open) return open;
  call->at = clock_.now();
  caller_->Make(*call);
  return {};
}

Result<void> StageCaller::Open() {
  if (caller_) return board_->Heal().map([](bool) {});
  if (!board_) {
    auto board = board::Board::Create(path_);
    if (!board) return tl::unexpected(board.error());
    board_.emplace(std::move(*board));
  }
  auto caller = board::Caller::Acquire(*board_, board::CallWriter::kControl);
  if (!caller) return tl::unexpected(caller.error());
  caller_.emplace(std::move(*caller));
  return {};
}

}  // namespace kaori::sim
