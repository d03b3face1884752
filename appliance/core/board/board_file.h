// The file in which a board lies: made whole, checked, and replaced where it is spoilt.
#pragma once

#include <cstdint>
#include <string>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::board {

// Opens the board's file for reading and checks its head and size. Never waits. The descriptor is the caller's, and keeps
// naming this file when another one is put at the path. Any thread. Errors:
//   no_such_file_or_directory  there is no board
//   bad_message                it was a board, and is spoilt: its head does not add up, or its size is wrong
//   invalid_argument           it never was a board, or is one of another version or layout: the attempt says
//                              which
//   permission_denied
Result<UniqueFd> OpenFile(const std::string& path);

// The same; where there is none a fresh board is made, and a spoilt one is replaced by a fresh one. Either
// appears whole or not at all, whoever else makes one at the same time. Errors: those of the file system, and
// invalid_argument as above: a file that never was a board is not written over.
Result<UniqueFd> OpenOrMakeFile(const std::string& path);

// Whether two descriptors name one inode of one file system; false where either cannot be asked. Paths would
// not do: the file at a path changes when a board is replaced.
bool IsSameFile(int a, int b);

}  // namespace kaori::board
