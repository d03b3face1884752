// What a box keeps of an update between its starts.
//
// In the folder `update` of the data partition lie
//   pending   the update that lies in the other slot and waits to be tried, or is being tried
//   last-try  what became of the last try, and the end of its log
//   before    the system that the last update was brought in beside, or tried from: it lies in its slot until the next update
//             is written there
//   overwritten  that note, from when the writing is begun until the update is whole: how old what lies there may still be
//   reserved  room for these, so that a partition which becomes full still takes them
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "appliance/core/update/pending.h"
#include "drivers/base/result.h"

namespace kaori::update {

// One thread. Every call blocks for the disk. An interface, so that tests see in which order things are kept.
class Notes {
 public:
  virtual ~Notes() = default;
  virtual std::optional<Pending> ReadPending() const = 0;
  // Each returns once it is on the disk. Errors: those of WriteWholeFile, rename(2) and unlink(2).
  virtual Result<void> KeepPending(const Pending& pending) = 0;
  virtual Result<void> ForgetPending() = 0;
  // The same three words as of an update that waits; its tries say nothing.
  virtual std::optional<Pending> ReadBefore() const = 0;
  virtual Result<void> KeepBefore(const Pending& before) = 0;
  // Nobody goes back to it from here on. Until the writing has ended its note is the overwritten one.
  virtual Result<void> BeginOverwriting() = 0;
  virtual Result<void> EndOverwriting() = 0;
  virtual std::optional<Pending> ReadOverwritten() const = 0;
  // Lines: what became of the try, then the end of its log. Empty where nothing was tried.
  virtual std::string ReadLastTry() const = 0;
  // An empty text removes it.
  virtual Result<void> KeepLastTry(std::string_view text) = 0;
  // Takes room by which each of the others can be kept once more, however full the disk becomes. Errors: those of WriteWholeFile;
  // no_space_on_device, where it is full already.
  virtual Result<void> Reserve() = 0;
};

// In this folder, which is made where it is missing.
std::unique_ptr<Notes> OpenNotes(const std::filesystem::path& folder);

}  // namespace kaori::update
