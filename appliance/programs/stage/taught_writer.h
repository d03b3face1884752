// Writes what was taught into the box's own roles.toml, beside the frames.
#pragma once

#include <atomic>
#include <filesystem>
#include <variant>

#include "appliance/core/roles/taught.h"
#include "drivers/base/background_writer.h"

namespace kaori::stage {

// The box's own file of roles, and what it lies over.
struct OwnRoles {
  std::filesystem::path file;  // Empty: the box keeps none.
  roles::Items items;          // That roles may name, by the numbers of the show.
  show::Roles below;           // Those of the show.
};

// A control for a level, or a button for a call.
using Lesson = std::variant<roles::Taught, roles::TaughtButton>;

// One thread calls the members.
class TaughtWriter {
 public:
  // Borrows `own`, which stays as it is. Starts the thread.
  explicit TaughtWriter(const OwnRoles& own);

  // Adds what was taught to the file, and returns without waiting. The file as it was lies beside it
  // afterwards, as NAME.before. Only to be called while none is under way. What refuses is logged.
  void Write(const Lesson& lesson);
  bool busy() const { return writer_.busy(); }

  // Of the last Write, once it is no longer busy.
  bool failed() const { return failed_.load(std::memory_order_acquire); }
  // The roles as they are played with the file from the next start on.
  const show::Roles& laid() const { return laid_; }

 private:
  // On the thread. Errors: those of the file, and of roles::Teach.
  Result<void> WriteOut();

  const OwnRoles& own_;
  Lesson lesson_;  // The thread owns both while the writer is busy.
  show::Roles laid_;
  std::atomic<bool> failed_ = false;
  BackgroundWriter writer_;  // Last: it uses all the others.
};

}  // namespace kaori::stage
