// What the sculptor's tests share: the default show, its cast, and files of a show with something changed.
#pragma once

#include <filesystem>
#include <string>

#include "render/face/cast.h"

namespace kaori::tests {

std::filesystem::path DefaultShowFolder();

// Sculpted once.
const face::Cast& SculptedCast();

// A copy of the default show's sculptor's files in a folder of its own, gone with the object.
class ShowCopy {
 public:
  ShowCopy();
  ~ShowCopy();
  ShowCopy(const ShowCopy&) = delete;
  ShowCopy& operator=(const ShowCopy&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  // Replaces the first `old_text`; the test fails where it does not stand in the file.
  void Replace(const std::string& file, const std::string& old_text, const std::string& new_text);
  // Sculpts it, and returns the error's message; empty where it went well.
  std::string Complaint() const;

 private:
  std::filesystem::path folder_;
};

}  // namespace kaori::tests
