// The lip camera's picture for the operators' monitor: a small file beside the board, in memory.
//
// Whoever shows the picture makes the file, and removes it when it is done; kaori-lips writes it only where
// it is, so that a box without a monitor draws no picture. It is written and read as a whole, by pwrite(2)
// and pread(2): a file that somebody cuts short harms neither end. Byte by byte, numbers little-endian:
//   "KLP1", u32 number, u32 width, u32 height, i64 time of the exposure in ns on CLOCK_MONOTONIC,
//   width * height times R, G, B and how much the pixel is paint, top row first, and u32 number again
// A picture whose two numbers differ was read while it was written.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::board {

inline constexpr int kLipPictureMost_px = 160;  // Of either side.

// The path of the file; `board` is that of the board's file.
inline std::string LipPicturePath(const std::string& board) {
  return board + ".picture";
}

struct LipPicture {
  int width_px = 0;
  int height_px = 0;
  Time at{};                         // When it was exposed.
  std::vector<std::uint8_t> pixels;  // Four bytes each, as in the file.
};

// The bytes of a file. `picture` has as many pixels as its size says. Pure.
std::vector<std::uint8_t> LipPictureBytes(const LipPicture& picture, std::uint32_t number);
// The inverse; none for other bytes, and for a picture that was being written. Pure.
std::optional<LipPicture> ParseLipPicture(std::span<const std::uint8_t> bytes);

// The end that shows the picture. One thread.
class LipPictureReader {
 public:
  // Makes the file, or empties one that was left there. Errors: those of open(2).
  static Result<LipPictureReader> Make(const std::string& path);
  LipPictureReader(LipPictureReader&&) = default;
  LipPictureReader& operator=(LipPictureReader&&) = delete;
  // Removes the file.
  ~LipPictureReader();

  // The newest picture; none before the first. Waits for nobody.
  std::optional<LipPicture> Read();

 private:
  LipPictureReader(UniqueFd file, std::string path) : file_(std::move(file)), path_(std::move(path)) {}

  UniqueFd file_;
  std::string path_;
  std::vector<std::uint8_t> bytes_;  // Of the last Read; kept for its memory.
};

// The end of kaori-lips. One thread.
class LipPictureWriter {
 public:
  // The file is that of LipPicturePath, and need not be there.
  explicit LipPictureWriter(std::string path) : path_(std::move(path)) {}

  // Whether somebody wants a picture now: ten times a second at most.
  bool IsDue(Time now);
  // Writes one. A failure is passed over: the next one may do.
  void Write(const LipPicture& picture);

 private:
  std::string path_;
  UniqueFd file_;  // Of the last IsDue that was true.
  Time due_at_{};
  std::uint32_t number_ = 0;
};

}  // namespace kaori::board
