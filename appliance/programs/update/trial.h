// The trial of an update: how it begins, and whether the system that was started for it stays.
#pragma once

#include <optional>
#include <string>

#include "appliance/core/update/messages.h"
#include "appliance/programs/update/installation.h"
#include "appliance/programs/update/notes.h"
#include "appliance/programs/update/reason.h"
#include "drivers/base/clock.h"
#include "drivers/ports/boot_choice.h"

namespace kaori::update {

inline constexpr std::uint32_t kMostTries = 3;

// A trial goes so. A person restarts the box: the try is counted, the firmware is told to start the other slot once
// (BeginTry). That slot notes that it has started (NoteStart) and looks at itself (Confirmation). Either it becomes the one
// that starts by itself (ConfirmTried), or it keeps why not (GiveWay) and the machine starts again, which is the slot before:
// that one finds the reason and says it (AfterStart). Whatever is cut off on the way, the slot before starts by itself.

// What is to be said, of which version, and why. `japanese` is the detail in that language; empty where there is no more than the
// text of an error.
struct Outcome {
  Message message = Message::kNothingWaits;
  std::uint32_t version = 0;
  std::string detail{};
  std::string japanese{};
};

// Has the next start try what waits: kRestarts, and the machine is to be restarted then. The try is counted
// before it is made, so that a cut in between never tries without end; one that the firmware refuses does not count. `version` is that
// of the running system, which is noted as the one before.
Outcome BeginTry(ports::BootChoice& choice, Notes& notes, std::uint32_t version);

// The running system can play no show: the disk's other one is tried once, as an update would be, and stays where its face
// is seen. What is answered is as of BeginTry; kTriedOften where it was tried before, by whomever; kBelowLeast where it is older than the
// running system lets this box become, `running.least`.
Outcome TryOther(ports::BootChoice& choice, Notes& notes, const Running& running);

// The same for a person: what waits, or where nothing does the system from which the last update was tried, as long as its slot is not
// written anew. kBelowLeast as of TryOther; kNothingWaits where there is neither.
Outcome TryWhatIsThere(ports::BootChoice& choice, Notes& notes, const Running& running);

// Tells a fault that lasts from one that comes and goes: a disk that is lost for a moment gives every show the same error, and
// the stage reads one at its next try. Pure; one thread.
class LastingFault {
 public:
  static constexpr Duration kLasts = std::chrono::seconds(10);

  // Whether it has been there for kLasts on end. To be asked several times in that span.
  bool Lasts(bool is_there, Time now);

 private:
  static constexpr Time kNever = Time::max();
  Time since_ = kNever;
};

// What a start finds, before anything is looked at:
//   kLooking   this system is being tried
//   kWaits     an update waits that was not tried yet
//   kGaveWay, kTriedOften   it was tried and this system came back; with what the try left to be said
//   kNothingWaits   and where what waited is what runs by itself, its note is removed: the power went after it was
//              confirmed
Outcome AfterStart(ports::BootChoice& choice, Notes& notes);

// The tried system has come so far: kept as its reason until there is a better one, so that a cut or a hang in its trial is
// told from a system that never started. What cannot be kept is missing there.
void NoteStart(Notes& notes);

// Looks for 180 s whether all has been well for 60 s on end. Pure; one thread.
class Confirmation {
 public:
  static constexpr Duration kHolds = std::chrono::seconds(60);
  static constexpr Duration kLongest = std::chrono::seconds(180);
  enum class Verdict { kLooking, kStays, kGivesWay };

  explicit Confirmation(Time began) : began_(began) {}

  // `fault` is what is not well at `now`; empty: nothing. A verdict stands.
  Verdict Observe(const Reason& fault, Time now);
  // The last fault; empty where there was none yet.
  const Reason& reason() const { return reason_; }

 private:
  Time began_;
  std::optional<Time> well_since_;
  Reason reason_;
  Verdict verdict_ = Verdict::kLooking;
};

// Makes the tried system the one that starts by itself, and only then forgets that it waited and how the try went.
// Errors: those of Confirm; what waits is tried again then.
Result<void> ConfirmTried(ports::BootChoice& choice, Notes& notes);

// Keeps why the tried system gives way, with the end of its log, for the one that starts next.
Result<void> GiveWay(Notes& notes, const Reason& reason, std::string_view log);

}  // namespace kaori::update
