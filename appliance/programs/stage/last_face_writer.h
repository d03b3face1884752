// The thread that waits for the disk while the last face is written. Buffers are reused, so that the second
// writing and those after it allocate nothing.
#pragma once

#include <atomic>
#include <system_error>

#include "appliance/programs/stage/last_face.h"
#include "drivers/base/background_writer.h"

namespace kaori::stage {

// Called by one thread. What cannot be written is logged in one line for each cause, and dropped.
class LastFace::Writer {
 public:
  explicit Writer(LastFaceFile where);
  // The image, to be filled for the next Write; null while a writing is under way. Owned by the writer.
  SmallImage* idle() { return writer_.busy() ? nullptr : &image_; }
  // Hands the filled image over with its state, and returns without waiting. Only to be called where idle()
  // gave the image.
  void Write(const board::Performance& performance);

  // The last writing failed; false from the next one on.
  bool failed() const { return failed_.load(std::memory_order_acquire); }

  // Waits until nothing is under way.
  void Finish() { writer_.Finish(); }

 private:
  // Writes picture, state and end as one file. Errors: those of WriteWholeFile.
  Result<void> WriteOut();

  LastFaceFile where_;
  SmallImage image_;  // The thread owns it while the writer is busy.
  board::Performance performance_;
  std::vector<std::uint8_t> picture_, state_;  // Of the thread.
  std::error_code logged_;
  std::atomic<bool> failed_ = false;
  BackgroundWriter writer_;  // Last: it uses all the others, and writes what it was given before it ends.
};

}  // namespace kaori::stage
