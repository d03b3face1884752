// One line to standard error for each decision of a program, with its severity where the journal reads it.
#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

namespace kaori {

// How much of the matter is left to people. Priorities of syslog(3), as sd-daemon(3) writes them before
// a line: "<4>". `journalctl -p warning` filters by them. Others of the eight are not used: there is no
// debug log, and what would be worse than a crash is for the kernel to say.
enum class Severity : int {
  kCrash = 2,    // A signal ends the program (crash_report.h); journald writes it to the disk at once.
  kError = 3,    // The program ends, or a part of the show is missing until somebody acts.
  kWarning = 4,  // Something failed; the show goes on without it, or it is tried again.
  kInfo = 6,     // An expected change of state.
};

// Sets the name that stands before every line. Called once, by main (BeginProgram does
// it), before any thread starts: reading it takes no lock.
void SetLogName(std::string_view name);

// What stands before a line of the log: "name: ", after "<severity>" where standard error is the journal. For whom
// cannot use LogLines when it is time, such as a signal handler. Any thread; allocates.
std::string LogPrefix(Severity severity);

// Writes "name: line" for each line of `lines`, all of them in one write(2). Where standard error is the
// journal (JOURNAL_STREAM names its device and inode), each line begins with "<severity>"; on a terminal, in
// a pipe or in a file it does not. Any thread; blocks only as long as the reader of standard error does. What
// cannot be written is lost: nobody is left to be told.
void LogLines(Severity severity, std::string_view lines);

// Log an expected change of state, a failure that the show survives, and one that it does not. A
// program logs where it decides what to do; drivers return errors and log nothing. They
// allocate: never on the frame path in a show that runs well.
template <class... Args>
void Log(fmt::format_string<Args...> format, Args&&... args) {
  LogLines(Severity::kInfo, fmt::format(format, std::forward<Args>(args)...));
}

template <class... Args>
void LogWarning(fmt::format_string<Args...> format, Args&&... args) {
  LogLines(Severity::kWarning, fmt::format(format, std::forward<Args>(args)...));
}

template <class... Args>
void LogError(fmt::format_string<Args...> format, Args&&... args) {
  LogLines(Severity::kError, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace kaori
