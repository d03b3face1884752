// What a program says when a signal ends it: where it was, as addresses that a build's symbols turn into lines.
#pragma once

namespace kaori {

// From now on each SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGSYS and SIGABRT of the process leaves a report on standard
// error, in one write(2) of 4096 bytes at most, and then ends the process as it would have without. Called once, by
// BeginProgram, after SetLogName and before any thread starts. With sanitizers, which report for themselves, it does
// nothing. An overflow of the stack is reported of the first thread alone; in another one the process ends without a
// word. A report is these lines, each after the log's name, and after "<2>" where standard error was the journal
// at the time of the call: journald writes what is critical to the disk at once, before a power switch is thrown.
//
//   crash: signal 11 after 5405.250 s in thread kaori-stage
//   crash: #0 kaori-stage+0x41b2c 2f0a...
//
// #0 is the instruction at which the signal came, each other frame the return address into its caller, 24 at most.
// An address is relative to its module, as the linker laid it out (addr2line(1) wants it so); after it stands the
// module's build id in hexadecimal digits, or "-" where it has none. A module is its file's name without the folder;
// an address of no module is "?+0x0 -". Nothing else of the process's memory is in a report: neither registers nor
// values nor paths, so that it can be handed on. `./box symbols` reads it.
void ReportCrashes();

}  // namespace kaori
