// One line to standard error for each decision a program takes; the journal stamps it.
#pragma once

#include <string_view>

#include <fmt/format.h>

namespace kaori {

// Writes "name: line" in one write; `name` is the program's (set once in main). Any thread.
void SetLogName(std::string_view name);
void LogLine(std::string_view line);

template <class... Args>
void Log(fmt::format_string<Args...> format, Args&&... args) {
  LogLine(fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace kaori
