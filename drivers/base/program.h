// How every program begins and how it ends with an error.
#pragma once

#include <string_view>

#include "drivers/base/result.h"

namespace kaori {

// Called first by main. Sets the log's name, and makes the two exceptions that a program
// cannot prevent (std::bad_alloc, and std::system_error where no thread can be started)
// end it with one line and status 1. Every other exception is our own bug and still
// aborts, and a program that a signal ends leaves a report (crash_report.h). `name` is
// copied.
void BeginProgram(std::string_view name);

// Logs the error with severity kError, a line for each of its lines, and returns
// `status` for main to return: 1 is a failure, 2 a command that was misused. It does
// not end the program itself, so that destructors run.
[[nodiscard]] int ExitWithError(const Error& error, int status = 1);

}  // namespace kaori
