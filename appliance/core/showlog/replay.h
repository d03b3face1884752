// Plays a show log again: the same frames, to the bit.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "appliance/core/performance/animate.h"
#include "appliance/core/show/show.h"
#include "appliance/core/showlog/log_file.h"

namespace kaori::showlog {

// Pure but for the two that it borrows, which outlive it. The state is taken from the log where a stretch
// begins, and is the replay's own from there on: each frame is made from the one before, as it was on the
// evening.
class Replay {
 public:
  // `show` is the one that was played, with the roles of the box.
  Replay(const LogFile& log, const show::Show& show) : log_(log), show_(show) {}

  // Goes to the chunk in which `at` lies, or to the next one; the following Next gives its first frame.
  void GoTo(Time at);

  // Reads the next frame and makes it. False at the end of the log. A chunk that cannot be played is named
  // and passed over.
  bool Next();

  // The two halves of Next, for whoever plays something else over what was read. A frame that was read and
  // not made leaves made() as it was, but where a stretch begins: there its state is the log's.
  bool Read();
  void Make();

  // The frame that was made last.
  const performance::Performed& made() const { return made_; }
  // Of the frame that was read last: what it had seen of the board, when it was presented, its board and its
  // events.
  const performance::SeenInput& seen() const { return seen_; }
  Time presented_at() const { return input_.presented_at; }
  const board::Snapshot& board() const { return input_.board; }
  const performance::InputEvents& events() const { return input_.events; }
  // True where the frame shows what it showed then.
  bool same() const { return same_; }
  // True where it follows the one before without a gap.
  bool follows() const { return follows_; }

  std::uint64_t frames() const { return frames_; }
  std::uint64_t frames_that_differ() const { return differ_; }
  std::optional<Time> first_difference() const { return first_difference_; }
  const std::vector<std::string>& faults() const { return faults_; }

 private:
  // Reads the next frame's bytes into input_ and, where it has one, state_. Nothing is changed where they are
  // none; then why.
  std::optional<std::string> ReadFrame();
  std::optional<std::string> ReadState(std::span<const std::uint8_t> from, std::size_t& at);
  void BeginChunk();

  const LogFile& log_;
  const show::Show& show_;
  std::size_t chunk_ = 0, at_ = 0;  // Of the next frame: its chunk, and where in it.
  std::uint32_t frame_ = 0;         // In that chunk.
  bool goes_on_ = false;            // made_.state is that of the frame before.
  bool follows_ = false, same_ = true;
  FrameTimes times_;
  FrameWords words_{};
  StateWords state_words_{};
  FrameInput input_;
  performance::SeenInput seen_;  // By the frame before.
  std::uint16_t sum_ = 0;
  performance::Performed made_;
  std::uint64_t frames_ = 0, differ_ = 0;
  std::optional<Time> first_difference_;
  std::vector<std::string> faults_;
};

}  // namespace kaori::showlog
