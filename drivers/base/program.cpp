#include "drivers/base/program.h"

#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <system_error>

#include "drivers/base/crash_report.h"
#include "drivers/base/log.h"

namespace kaori {
namespace {

// Nothing may be allocated where memory is what lacks: the line was made when the program began.
std::string& NoMemoryLine() {
  static std::string line;
  return line;
}

[[noreturn]] void EndWithoutMemory() {
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, NoMemoryLine().data(), NoMemoryLine().size());
  std::_Exit(EXIT_FAILURE);
}

[[noreturn]] void EndWithException() {
  try {
    // A terminate handler learns of the exception only by throwing it again.
    if (const auto thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    EndWithoutMemory();
  } catch (const std::system_error& error) {
    LogError("the system refuses a thread or a lock: {}", error.what());
    // Destructors of statics may wait for threads that never began: they are not run.
    std::_Exit(EXIT_FAILURE);
  } catch (...) {
  }
  std::abort();
}

}  // namespace

void BeginProgram(std::string_view name) {
  SetLogName(name);
  NoMemoryLine() = std::string(name) + ": there is no memory left; the program ends\n";
  std::set_terminate(EndWithException);
  ReportCrashes();
}

int ExitWithError(const Error& error, int status) {
  LogError("{}", error.message());
  return status;
}

}  // namespace kaori
