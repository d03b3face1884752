// What happened on an evening, read from its show log.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "appliance/core/show/show.h"
#include "appliance/core/showlog/log_file.h"
#include "drivers/base/clock.h"

namespace kaori::report {

// A cue that was played.
struct PlayedCue {
  std::size_t cue = 0;  // Of the show's cues.
  Time at{};
  std::string clock;    // The time of day.
  const char* by = "";  // What called it: "foot switch", "page", "button or key", "by itself", "jump".
  bool chain = false;   // It came by itself, with or after another one.
};

// Something that a person should know of: a device that was lost, a GO that was refused.
struct Incident {
  Time at{};
  std::string clock, what;
};

// From the first cue of an act to its last one, and until the next act's first, or the log's end.
struct ActPlayed {
  std::string act, begins;
  Duration length{}, until_next{};
};

// Between a control that moved and the frame that showed it.
struct Delays {
  double median_ms = 0, p99_ms = 0;
  std::size_t frames = 0;  // That were measured; 0: nothing moved.
};

// All that a report says of an evening. Times of day are texts in the time zone that the box had then.
struct Evening {
  std::string box, day, begins, ends;  // Of the box its name; empty where the log does not say.
  Duration length{};
  std::uint64_t frames = 0, frames_that_differ = 0;
  std::vector<PlayedCue> cues;
  std::vector<ActPlayed> acts;
  std::vector<Incident> line_checks;  // Each with what came of it.
  std::vector<Incident> refused, incidents;
  Delays hand_to_scanout;
  Delays lips_to_scanout;           // Of mouths that a camera saw well.
  std::vector<std::string> faults;  // Of the logs themselves.
};

// Plays the logs of one evening again, in their order, with the show that was played; takes some seconds for
// an hour. Pure.
Evening ReadEvening(std::span<const showlog::LogFile* const> logs, const show::Show& show);

// The same of each evening in a list of logs, the oldest first. A restart of the stage begins a new file; the box's own
// start is what separates two evenings. `logs` has one at least.
std::vector<Evening> ReadEvenings(std::span<const showlog::LogFile> logs, const show::Show& show);

// When each cue is usually played, after the first cue of its act: the median over these evenings, of the
// first time that it was played on each.
std::map<std::size_t, Duration> UsualTimes(std::span<const Evening> evenings, const show::Show& show);

// The same of one evening.
std::map<std::size_t, Duration> TimesInActs(const Evening& evening, const show::Show& show);

// The act of a cue: its own, or that of the cue before it which names one.
const std::string& ActOf(const show::Show& show, std::size_t cue);

}  // namespace kaori::report
