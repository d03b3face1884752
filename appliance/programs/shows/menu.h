// What whoever stands before the box sees and does: the list of what is on the stick, which one is marked,
// and the one that was taken. Presses come from the board; nothing is drawn here.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "appliance/core/board/sections.h"
#include "appliance/programs/shows/messages.h"
#include "appliance/programs/shows/stick.h"

namespace kaori::shows {

// One thing that can be taken: a show, a key of somebody's whose shows the box shall play, or a show that is on the
// box already.
struct Choosable {
  enum class Kind : std::uint8_t { kShow, kKey, kBack } kind = Kind::kShow;
  Offer offer;
  std::string remark;     // "48 MB", or a key's fingerprint.
  show::PublicKey key{};  // Of a key: what is taken is what was shown, whatever the stick says later.
  std::string id{};       // Of a show that is on the box: as in store::Choice.
};

// Pure but for what it remembers. One thread.
class Menu {
 public:
  // What can be taken from now on; the first is marked. Presses from before count no more. `left_out` more lie
  // on the stick, which have no number.
  void Offer(std::vector<Choosable> choices, std::size_t left_out = 0);

  // What can be taken stays; presses from before count no more.
  void ForgetPresses();

  // Looks at the board: a press of a key or button 1 to 8 takes that one; arrow keys move the mark; GO and
  // Enter take the marked one. The result is taken now; nothing where nobody took anything.
  std::optional<Choosable> Read(const board::Stamped<board::Keys>& keys,
                                const board::Stamped<board::Surface>& surface,
                                const board::Stamped<board::Lines>& lines);

  // The lines for a screen, in one language: the message, and below it what can be chosen.
  std::vector<std::string> Lines(Message message, Language language, const std::string& name = {},
                                 const std::string& detail = {}) const;

 private:
  // The number, from 0, of what a press took; nothing where it took nothing or only moved the mark.
  std::optional<std::size_t> ReadKeys(const board::Stamped<board::Keys>& keys);
  std::optional<std::size_t> ReadButtons(const board::Stamped<board::Surface>& surface);
  std::optional<std::size_t> ReadGo(const board::Stamped<board::Lines>& lines);

  std::vector<Choosable> choices_;
  std::size_t left_out_ = 0;
  std::size_t marked_ = 0;
  // Counters as they stood at the last look; nothing before the first.
  std::optional<std::uint32_t> keys_seen_, buttons_seen_, go_seen_;
};

}  // namespace kaori::shows
