#include "hw-sim/monitor/stage_caller.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "drivers/base/number.h"

namespace kaori::sim {
namespace {

// A verb in the page's words, and what follows it.
struct Form {
  std::string_view word;
  board::CallVerb verb;
  std::size_t words;  // With the verb.
  bool of_a_cue;      // The word behind the verb is the number of a cue; else a place, counted from 0.
  std::string_view example;
};
constexpr std::array<Form, 9> kForms{{{"goto", board::CallVerb::kGoTo, 2, true, "goto 14"},
                                      {"standby", board::CallVerb::kStandBy, 2, true, "standby 2.10"},
                                      {"level", board::CallVerb::kLevel, 3, false, "level 8 0.25"},
                                      {"letgo", board::CallVerb::kLetGo, 2, false, "letgo 8"},
                                      {"load", board::CallVerb::kLoadRole, 3, false, "load 1 0"},
                                      {"check", board::CallVerb::kLineCheck, 2, false, "check 1"},
                                      {"learn", board::CallVerb::kLearn, 3, false, "learn 1 8"},
                                      {"lock", board::CallVerb::kLock, 2, false, "lock 1"},
                                      {"motion", board::CallVerb::kMotion, 3, false, "motion 3 1"}}};

std::vector<std::string_view> WordsOf(std::string_view line) {
  std::vector<std::string_view> words;
  while (!line.empty()) {
    const auto end = std::min(line.find(' '), line.size());
    if (end > 0) words.push_back(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return words;
}

// The subject as the verb has it; nothing where the word is none.
std::optional<std::uint32_t> SubjectOf(const Form& form, std::string_view word) {
  if (!form.of_a_cue) return ParseNumber<std::uint32_t>(word);
  if (word.find_first_not_of("0123456789.") != std::string_view::npos) return std::nullopt;
  return board::CueKey(word);
}

// Too many words are refused as too few are: a call is done on a stage, and not guessed.
Result<board::Call> ReadCall(std::string_view line) {
  const std::vector<std::string_view> words = WordsOf(line);
  const std::string quoted = "\"" + std::string(line) + "\"";
  const auto* const form = std::ranges::find(kForms, words.empty() ? "" : words[0], &Form::word);
  if (form == kForms.end())
    return FailInput(
        quoted + " is no call; calls are goto, standby, level, letgo, load, check, learn, lock and motion");
  const auto expected = FailInput(quoted + ": expected such as " + std::string(form->example));
  if (words.size() != form->words) return expected;
  const auto subject = SubjectOf(*form, words[1]);
  const auto value = words.size() > 2 ? ParseNumber<double>(words[2]) : 0.0;
  if (!subject || !value || !std::isfinite(*value)) return expected;
  return board::Call{.verb = form->verb,
                     .subject = *subject,
                     .value = static_cast<float>(*value),
                     .source = board::CallSource::kPage};
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
