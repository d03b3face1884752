// The protocol between kaori-desk and kaori-lips: packets over a local socket beside the board's file.
//
// The desk sends commands as text, one a packet: "7 sample 0.5 0.52". The lips send binary packets of
// little-endian 32-bit words: first a hello, which carries the descriptor of the shared memory for pictures,
// then reports and notes of pictures. Everything here is pure and may be called from any thread.
//
// The socket is of SOCK_SEQPACKET: a packet arrives whole or not at all, and in order. Either end closes the
// connection over a packet that it does not understand, and drops packets that the other one does not take in
// time. One desk at a time is connected; a newer one replaces it.
//
// Binary packets, word by word (f: IEEE single, u: unsigned):
//   hello    "HKL1", u bytes of shared memory
//   report   "RKL1", u answered, u length of the complaint and its bytes, u step (255: none), f progress,
//            u done, u changes, u flags (1 unsaved, 2 saved, 4 before, 8 exposure free), 16 f values, 4 f box
//   note     "PKL1", u slot, u number, u width, u height
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/programs/lips/protocol/setting_table.h"
#include "drivers/base/result.h"

namespace kaori::lips {

// The path of the socket on which the lips listen for a desk; `board` is the path of the board's file.
inline std::string ServicePath(const std::string& board) {
  return board + ".lips";
}

// A pose, or ten seconds of speech, that a calibration measures. The number is the bit in Report::done.
enum class CalibrationStep : std::uint8_t { kShut, kOpen, kWide, kNarrow, kSpeak };
inline constexpr int kStepCount = 5;
// The step's name in commands: "shut", "open", "wide", "narrow" or "speak".
std::string_view NameOf(CalibrationStep step);
// The inverse of NameOf; none for any other name.
std::optional<CalibrationStep> StepNamed(std::string_view name);

enum class CommandKind : std::uint8_t {
  kSample,    // Samples the paint at (a, b), in parts of the picture from its left top corner.
  kFind,      // Samples the paint wherever it is found in the picture.
  kSet,       // Sets the setting `name` to a; b numbers the gesture, whose values make one change.
  kBegin,     // Begins the calibration step `name`.
  kStop,      // Cancels the step that is under way.
  kUndo,      // Undoes the newest change.
  kSaved,     // Goes back to the settings that are saved,
  kBefore,    // to those that were saved before them,
  kDefaults,  // or to those of a new box.
  kSave,      // Saves the settings to the disk.
  kExposure,  // a = 1 lets the camera find its exposure and colours; a = 0 holds them.
  kLook,      // Asks for small pictures during the next two seconds.
  kReturn,    // Gives the picture slot a back: its picture has been copied.
};

// A command of the desk. Fields that its kind does not name are unused.
struct Command {
  std::uint32_t number = 0;  // Given by the desk; the lips name it in Report::answered.
  // What the fields after it mean is said at the kind.
  CommandKind kind{};
  float a = 0;
  float b = 0;
  std::string name{};
};
inline constexpr std::size_t kMaxCommandBytes = 160;

// The command as a packet. `command.kind` is one of the kinds; arguments that its verb does not have are left
// out.
std::string CommandText(const Command& command);

// The inverse of CommandText. Errors:
//   invalid_argument  the text is too long, has a control character, no number, an unknown verb or wrong arguments: a
//                     position beside the picture, a step that there is not, a number that is not finite
Result<Command> ParseCommand(std::string_view text);

// The state of the calibration. The lips send it ten times a second, and at once when it changed.
struct Report {
  std::uint32_t answered = 0;                 // The number of the command that was executed last.
  std::string complaint;                      // Why that command failed; empty: it succeeded.
  std::optional<CalibrationStep> step{};      // The step that is under way.
  float progress = 0;                         // Of that step, 0 .. 1.
  std::uint32_t done = 0;                     // Bit n: step n was done since the lips started.
  std::uint32_t changes = 0;                  // How many changes can be undone.
  bool unsaved = false;                       // The settings in use differ from those that are saved.
  bool saved = false;                         // There are saved settings,
  bool before = false;                        // and ones that were saved before them.
  bool exposure_free = false;                 // The camera's exposure is free and not held.
  std::array<float, kSettingCount> values{};  // By the number of the setting.
  // The mouth in the picture: left, top, right, bottom, in parts of the picture; all 0: no mouth is seen.
  std::array<float, 4> box{};
  bool operator==(const Report&) const = default;
};

// A small picture that lies in slot `slot` of the shared memory: for each pixel R, G, B and how much the
// pixel is paint, each 0 .. 255, top row first. The slot belongs to the desk from this note on, until it
// sends "return"; the lips write to no slot that is the desk's.
struct PictureNote {
  std::uint32_t slot = 0;
  std::uint32_t number = 0;  // Counts the pictures.
  std::uint32_t width_px = 0;
  std::uint32_t height_px = 0;
};
// Slot n begins at byte n * kPictureSlotBytes of the shared memory. Three of them: one that is drawn, one on
// its way, one that is copied.
inline constexpr std::uint32_t kPictureSlots = 3;
inline constexpr std::uint32_t kPictureMaxWidth_px = 400;
inline constexpr std::uint32_t kPictureMaxHeight_px = 400;
inline constexpr std::uint32_t kPictureSlotBytes = kPictureMaxWidth_px * kPictureMaxHeight_px * 4;

// No packet of the lips is longer.
inline constexpr std::size_t kMaxPacketBytes = 512;
// Packets of the lips. The hello is sent first, together with the descriptor of the shared memory
// (SCM_RIGHTS).
std::vector<std::uint8_t> HelloPacket();
std::vector<std::uint8_t> Packet(const Report& report);
std::vector<std::uint8_t> Packet(const PictureNote& note);

// Each returns false or nothing for a packet of another kind or version, of a wrong length, or with a value
// out of its range.
bool IsHello(std::span<const std::uint8_t> packet);
std::optional<Report> ReadReport(std::span<const std::uint8_t> packet);
std::optional<PictureNote> ReadPictureNote(std::span<const std::uint8_t> packet);

}  // namespace kaori::lips
