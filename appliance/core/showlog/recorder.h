// Writes the show log in memory, frame by frame, and hands over whole chunks.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "appliance/core/performance/animate.h"
#include "appliance/core/showlog/format.h"

namespace kaori::showlog {

// Two threads: Note and Close are the stage's, handed and Release are those of whoever writes to the disk.
// All memory is made in the constructor; the stage never waits. A chunk that is full while the one before is
// still being written is dropped, and the next one says how many frames are missing.
class Recorder {
 public:
  // `ask` is called by the stage's thread whenever a chunk is handed over; it must not wait. handed() gives
  // it until Release.
  explicit Recorder(std::function<void()> ask);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  // What Animate was given. `changed`: `state` is not what the frame before made, since an editor has changed
  // it; what it has seen of the board may differ at any time.
  struct Given {
    Time presented_at{};
    const board::Snapshot& board;
    const performance::State& state;
    const performance::InputEvents& events;
    bool changed = false;
  };

  // Adds a frame and what came of it; closes the chunk after kChunkTime. Takes some microseconds; allocates
  // nothing.
  void Note(const Given& given, const performance::Performed& made);

  // Hands over what there is: at an orderly end.
  void Close();

  // The chunk that is to be written; empty: none.
  std::span<const std::uint8_t> handed() const;
  // It is written, or given up.
  void Release() { handed_bytes_.store(0, std::memory_order_release); }

 private:
  // Adds the bytes of one frame behind `bytes_`.
  void Append(const Given& given, bool with_state, std::uint16_t sum);
  // Whether the events follow from the board and from what the frame before had seen, which then becomes this
  // one's.
  bool FollowFromBoard(const Given& given);
  std::span<std::uint8_t> room() { return std::span(buffers_[filling_]).subspan(kChunkHead_bytes + bytes_); }

  std::function<void()> ask_;
  std::array<std::vector<std::uint8_t>, 2> buffers_;
  std::size_t filling_ =
      0;  // Which buffer is the stage's; the other one is the writer's while handed_bytes_ is not 0.
  std::atomic<std::size_t> handed_bytes_ = 0;
  std::size_t handed_ = 0;
  // Of the chunk that is being filled.
  std::size_t bytes_ = 0;
  std::uint32_t frames_ = 0;
  Time first_{};
  bool continues_ = false;
  std::uint32_t number_ = 0, lost_frames_ = 0;
  FrameTimes times_;
  performance::SeenInput seen_;  // By the frame before.
  FrameWords before_{}, now_{};
  StateWords state_{};
};

}  // namespace kaori::showlog
