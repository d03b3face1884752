#include "appliance/authoring/pack/progress.h"

#include <unistd.h>

#include <cstdio>

#include <fmt/format.h>

namespace kaori::authoring {
namespace {

// To the line's start, and erase to its end (ECMA-48, EL).
constexpr std::string_view kEraseLine = "\r\x1b[K";

}  // namespace

// Standard error alone counts: results may go to a file while people watch.
ProgressLine::ProgressLine() : begun_(clock_.now()), on_terminal_(::isatty(STDERR_FILENO) == 1) {}

// A log keeps all of its lines: only what stands on a terminal is erased.
ProgressLine::~ProgressLine() {
  if (on_terminal_ && shown_) fmt::print(stderr, "{}", kEraseLine);
}

// Without a terminal every step is a line, so that a log shows where the time went.
void ProgressLine::Step(std::string_view what) {
  const std::string line = fmt::format("[{:5.1f} s] {}", seconds(), what);
  if (on_terminal_)
    fmt::print(stderr, "{}{}", kEraseLine, line);
  else
    fmt::print(stderr, "{}\n", line);
  // A line without a newline may stay in a buffer, whatever the C library says of standard error.
  std::fflush(stderr);
  shown_ = true;
}

// The erased step is not drawn again: the next Step writes a new line below the note.
void ProgressLine::Note(std::string_view what) {
  fmt::print(stderr, "{}{}\n", on_terminal_ && shown_ ? kEraseLine : "", what);
}

}  // namespace kaori::authoring
