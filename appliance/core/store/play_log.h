// What became of the shows since the box was switched on: which one plays, and which ended the stage how
// often. It lies in memory (/run/kaori/plays), so that a show that was given up gets another trial after the
// box was off.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/core/store/choice.h"
#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::store {

// A show gives way to the one before it where it ends the stage so often within the span, or so often one
// after the other without having played for that span at all: one that hangs, or ends slowly, takes longer
// for each end.
inline constexpr int kMostEnds = 3;
// After so many of them the root's show is read before it is believed: its disk may be spoilt.
inline constexpr int kDoubtedEnds = 2;
inline constexpr Duration kEndsWithin = std::chrono::minutes(1);
inline constexpr Duration kSettlesAfter = kEndsWithin;

// A choice that was made anew is another trial: entries are of one generation of the choice.
struct PlayLog {
  std::uint64_t generation = 0;
  std::string playing;   // The show that a stage began to play and did not end in order; empty: none.
  std::string last;      // The show that was played last, and whose state lies on the board; empty: none.
  bool settled = false;  // The one that plays has been seen for kSettlesAfter.
  int unsettled = 0;     // Ends of one show, one after the other, before it had settled.
  // Ends of the stage that were none of its own will, oldest first, 16 at most.
  struct End {
    std::string show;
    Time at{};
    friend bool operator==(const End&, const End&) = default;
  };
  std::vector<End> ends;
  std::vector<std::string> given_up;
  friend bool operator==(const PlayLog&, const PlayLog&) = default;
};

// A stage starts at `now`: counts how the last one ended, and gives up what has ended the stage too often.
// The result names no show as playing. Pure.
PlayLog Started(PlayLog log, const Choice& choice, Time now);

// Whether a show has ended the stage so often that its file is looked at anew. Pure.
bool IsDoubted(const PlayLog& log, const std::string& show, Time now);

// The shows that are left to try, in their order; the root's is always among them, and its copy the last. Pure.
std::vector<std::string> ToTry(const PlayLog& log, const Choice& choice);

// As text, and back; an unsound text is an empty log. Pure.
std::string Format(const PlayLog& log);
PlayLog ParsePlayLog(std::string_view text);

// Beside the board, in memory, the stage says of the root's show:
//   show-settled  it has been seen for kSettlesAfter, so that a copy of it is worth keeping
//   show-spoilt   it cannot be read, and its copy plays: lines for the status picture
//   no-show       no show can be read at all, and why
inline constexpr const char* kSettledFile = "show-settled";
inline constexpr const char* kSpoiltFile = "show-spoilt";
inline constexpr const char* kNoShowFile = "no-show";

// Where the stage keeps the log: beside the board. Pure.
std::filesystem::path PlayLogBeside(const std::filesystem::path& board);

// The log of a file; an empty one where there is no sound log. Blocks for a file in memory.
PlayLog ReadPlayLog(const std::filesystem::path& file);

}  // namespace kaori::store
