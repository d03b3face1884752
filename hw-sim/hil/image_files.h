// Which image was tried, by the files of which an update of the box is made.
#pragma once

#include <map>
#include <string>

namespace kaori::hil {

// SHA-256, as sha256sum writes it, of each file of an image's folder that an update carries: root, hash tree, and the kernels or, for a
// board, what its firmware starts from. By the file's name below the folder; files that are not there, or cannot be read, are left out.
// What sha256sum says goes through `log`. Blocks while it reads, for seconds.
std::map<std::string, std::string> UpdateFileHashes(const std::string& image, const std::string& log);

}  // namespace kaori::hil
