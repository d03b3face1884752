// The folder of shows as whoever installs sees it: names, and files that are written from front to back. An
// interface, so that tests can cut the power at each of its steps.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/result.h"

namespace kaori::shows {

// A file that is being written. Destroying it leaves what was written under its name.
class Draft {
 public:
  virtual ~Draft() = default;
  // Errors: no_space_on_device, and others of write(2).
  virtual Result<void> Append(std::span<const std::uint8_t> bytes) = 0;
  // Returns once the content, not the name, is on the disk. Errors: those of fsync(2).
  virtual Result<void> Finish() = 0;
};

// Every call blocks for the disk. Names are plain names of files in the folder. A name that was made, renamed
// or removed survives a power cut once KeepNames has returned, and may or may not before.
class Folder {
 public:
  virtual ~Folder() = default;
  virtual std::filesystem::path path() const = 0;
  virtual Result<std::uint64_t> FreeBytes() const = 0;
  virtual Result<std::vector<std::string>> Names() const = 0;
  // How long a file is; 0 where there is none.
  virtual std::uint64_t BytesOf(const std::string& name) const = 0;
  // A small file; empty where there is none.
  virtual std::string Read(const std::string& name) const = 0;
  // Begins a file, in place of one that has this name.
  virtual Result<std::unique_ptr<Draft>> Begin(const std::string& name) = 0;
  // Replaces what has the name `to`.
  virtual Result<void> Rename(const std::string& from, const std::string& to) = 0;
  virtual Result<void> Remove(const std::string& name) = 0;
  virtual Result<void> KeepNames() = 0;
};

// The folder on the disk, which must exist.
std::unique_ptr<Folder> OpenFolder(const std::filesystem::path& path);

}  // namespace kaori::shows
