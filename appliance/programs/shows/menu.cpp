#include "appliance/programs/shows/menu.h"

#include <algorithm>
#include <utility>

#include "appliance/core/board/keys.h"
#include "appliance/core/board/lines.h"

namespace kaori::shows {
namespace {

// The codes of a log's presses since `seen`, oldest first; none at the first look.
std::vector<std::uint32_t> Since(std::optional<std::uint32_t>& seen, const board::PressLog& log) {
  std::vector<std::uint32_t> codes;
  const std::uint32_t before = std::exchange(seen, log.count).value_or(log.count);
  const std::uint32_t fresh = std::min<std::uint32_t>(log.count - before, board::PressLog::kKept);
  for (std::uint32_t n = log.count - fresh; n != log.count; ++n)
    codes.push_back(log.newest[n % board::PressLog::kKept].code & 0xFFU);
  return codes;
}

// In front of its name, for what comes from a stick and is no show.
std::string KindOf(const Choosable& choice) {
  if (choice.kind == Choosable::Kind::kKey) return "key ";
  if (choice.kind == Choosable::Kind::kUpdate) return "update ";
  if (choice.kind == Choosable::Kind::kRestore) return "restore ";
  return choice.kind == Choosable::Kind::kSettingsFile ? "settings " : "";
}

}  // namespace

void Menu::Offer(std::vector<Choosable> choices, std::size_t left_out, std::vector<std::string> notes) {
  choices_ = std::move(choices);
  ++number_;
  left_out_ = left_out;
  notes_ = std::move(notes);
  marked_ = 0;
  if (choices_.empty()) Shut();
  ForgetPresses();
}

void Menu::Open(Time now) {
  if (!choices_.empty()) open_until_ = now + kNobodyChooses;
}

void Menu::ForgetPresses() {
  keys_seen_.reset();
  buttons_seen_.reset();
  go_seen_.reset();
}

// Of several presses since the last look the first that takes something counts, and the arrows before it.
std::optional<std::size_t> Menu::ReadKeys(const std::vector<std::uint32_t>& codes, Time now) {
  for (const std::uint32_t code : codes) {
    if (code == board::key::kPageUp) IsOpen(now) ? Shut() : Open(now);
    if (!IsOpen(now)) continue;
    if (code >= board::key::k1 && code < board::key::k1 + choices_.size()) return code - board::key::k1;
    if (code == board::key::kEnter || code == board::key::kPadEnter) return marked_;
    if (code == board::key::kDown && marked_ + 1 < choices_.size()) ++marked_;
    if (code == board::key::kUp && marked_ > 0) --marked_;
  }
  return std::nullopt;
}

// The buttons of the first row, from the left, are the numbers of the list.
std::optional<std::size_t> Menu::ReadButtons(const std::vector<std::uint32_t>& codes) const {
  for (const std::uint32_t code : codes)
    if (code < choices_.size()) return code;
  return std::nullopt;
}

// A press that takes something marks it too, so that the screen shows what was meant. Keys, buttons and the
// foot switch are read at each look, so that none counts a press of long ago. The foot switch has no log: it
// counts its pushes, and any number of them since the last look is one.
std::optional<Choosable> Menu::Read(const board::Stamped<board::Keys>& keys,
                                    const board::Stamped<board::Surface>& surface,
                                    const board::Stamped<board::Lines>& lines, Time now) {
  const auto struck = Since(keys_seen_, keys.value.log), pushed = Since(buttons_seen_, surface.value.log);
  const std::uint32_t pushes = lines.value.pushes[static_cast<std::size_t>(board::Line::kGo)];
  const bool go = std::exchange(go_seen_, pushes).value_or(pushes) != pushes;
  if (IsOpen(now) && (go || !struck.empty() || !pushed.empty())) Open(now);
  const bool was_open = IsOpen(now);
  const auto by_key = ReadKeys(struck, now), by_button = ReadButtons(pushed);
  const std::size_t nothing = choices_.size();
  const std::size_t taken = by_key.value_or(by_button.value_or(go ? marked_ : nothing));
  if (!was_open || !IsOpen(now) || taken >= nothing) return std::nullopt;
  marked_ = taken;
  return choices_[taken];
}

std::vector<std::string> Menu::Labels() const {
  std::vector<std::string> labels;
  for (const Choosable& choice : choices_)
    labels.push_back(KindOf(choice) + choice.offer.name +
                     (choice.remark.empty() ? "" : "  " + choice.remark));
  return labels;
}

// The mark stays where it is: it is that of whoever stands before the box.
std::optional<Choosable> Menu::LineOf(std::uint32_t number, std::size_t line) const {
  if (number != number_ || line >= choices_.size()) return std::nullopt;
  return choices_[line];
}

// The list stays below each message, so that the next one can be taken while the last result is read. One
// that is shut is not shown: what it says would not be so.
std::vector<std::string> Menu::Lines(Message message, Language language, const std::string& name,
                                     const std::string& detail, bool open) const {
  std::vector<std::string> lines{Say(message, language, name, detail)};
  if (!open) {
    if (!choices_.empty() && message != Message::kShut)
      lines.emplace_back("  " + std::string(Words(Message::kShut, language)));
    return lines;
  }
  const std::vector<std::string> labels = Labels();
  for (std::size_t i = 0; i < labels.size(); ++i)
    lines.push_back((i == marked_ ? "> " : "  ") + std::to_string(i + 1) + ". " + labels[i]);
  if (left_out_ > 0)
    lines.push_back("  and " + std::to_string(left_out_) +
                    " more on the stick; take some off it to see them");
  for (const std::string& note : notes_) lines.push_back("     " + note);
  return lines;
}

}  // namespace kaori::shows
