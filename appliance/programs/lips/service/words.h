// What kaori-desk and kaori-lips say to each other, packet by packet, over a socket beside the board.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/programs/lips/calibration.h"
#include "appliance/programs/lips/lip_settings.h"
#include "drivers/base/result.h"

namespace kaori::lips {

// Where the lips listen for a desk: beside the board's file.
inline std::string ServicePath(const std::string& board) {
  return board + ".lips";
}

// The desk asks; a number tells one command from the next. As a packet: "7 sample 0.5 0.52".
enum class Ask : std::uint8_t {
  kSample,    // The paint, at (a, b) in parts of the picture, from the left top.
  kFind,      // The paint, wherever the mouth is expected.
  kSet,       // The value `name` to a; b counts the gesture.
  kBegin,     // A step of the calibration: `name` is shut, open, wide, narrow or speak.
  kStop,      // Gives the step up.
  kUndo,      // Takes the newest change back.
  kSaved,     // Goes back to what is on the disk,
  kBefore,    // to what was there before that,
  kDefaults,  // or to a box as it was delivered.
  kSave,
  kLight,   // The camera finds its exposure and colours anew: a is 1; 0 holds them.
  kLook,    // Somebody looks at the pictures: they come for the next two seconds.
  kReturn,  // The picture in slot a has been seen.
};
struct Command {
  std::uint32_t number = 0;
  Ask ask{};
  float a = 0;
  float b = 0;
  std::string name{};
};
inline constexpr std::size_t kMostCommandBytes = 160;
std::string CommandText(const Command& command);

// Errors: invalid_argument, with the word that is wrong.
Result<Command> ParseCommand(std::string_view text);

std::string_view NameOf(CalibrationStep step);
inline constexpr int kStepCount = 5;

// What the lips tell of the calibration, ten times a second and when it changed.
struct Report {
  std::uint32_t answered = 0;  // The command that was done last.
  std::string complaint;       // Why it was not; empty: it was.
  std::optional<CalibrationStep> step{};
  float progress = 0;
  std::uint32_t taken = 0;    // Bit n: step n was done since the lips began.
  std::uint32_t changes = 0;  // That can be taken back.
  bool unsaved = false;
  bool saved = false;   // There is a file to go back to,
  bool before = false;  // and one from before that.
  bool free_light = false;
  std::array<float, kSettingCount> values{};
  // The mouth in the picture: left, top, right, bottom, in parts of it; all 0: none is seen.
  std::array<float, 4> box{};
  bool operator==(const Report&) const = default;
};

// A small picture in the shared memory: R, G, B and how much each pixel is paint, 0 .. 255; top row first.
struct PictureNote {
  std::uint32_t slot = 0;
  std::uint32_t number = 0;
  std::uint32_t width_px = 0;
  std::uint32_t height_px = 0;
};
inline constexpr std::uint32_t kPictureSlots = 3;
inline constexpr std::uint32_t kPictureMostWidth_px = 400;
inline constexpr std::uint32_t kPictureMostHeight_px = 400;
inline constexpr std::uint32_t kPictureSlotBytes = kPictureMostWidth_px * kPictureMostHeight_px * 4;

// The lips speak: hello comes first, with the shared memory's descriptor.
inline constexpr std::size_t kMostWordBytes = 512;
std::vector<std::uint8_t> HelloPacket();
std::vector<std::uint8_t> Packet(const Report& report);
std::vector<std::uint8_t> Packet(const PictureNote& note);

// Nothing where the packet is none of that kind, or says what cannot be.
bool IsHello(std::span<const std::uint8_t> packet);
std::optional<Report> ReadReport(std::span<const std::uint8_t> packet);
std::optional<PictureNote> ReadPictureNote(std::span<const std::uint8_t> packet);

}  // namespace kaori::lips
