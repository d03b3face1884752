#include "appliance/programs/lips/protocol/protocol.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "drivers/base/number.h"
#include "firmware/wire/bytes.h"

namespace kaori::lips {
namespace {

// The first word of each packet names its kind and the version of the protocol, as four letters in memory:
// "HKL1", "RKL1" and "PKL1". Another version of the protocol has another last letter and is not understood.
constexpr std::uint32_t kHello = 0x314C4B48;    // "HKL1"
constexpr std::uint32_t kReport = 0x314C4B52;   // "RKL1"
constexpr std::uint32_t kPicture = 0x314C4B50;  // "PKL1"
// Five words and two: of the three packets only the report has a part of changing length, its complaint.
constexpr std::size_t kNoteBytes = 20;
constexpr std::size_t kHelloBytes = 8;
constexpr std::uint32_t kNoStep = 255;
// What is longer is cut off, so that a report fits into kMaxPacketBytes.
constexpr std::size_t kMaxComplaint = 160;

// What follows the verb of a command.
enum class Arguments : std::uint8_t { kNone, kPosition, kNumber, kStep, kNameAndNumbers };
struct Verb {
  std::string_view word;
  CommandKind kind;
  Arguments arguments;
};
constexpr Verb kVerbs[] = {
    {"sample", CommandKind::kSample, Arguments::kPosition},
    {"find", CommandKind::kFind, Arguments::kNone},
    {"set", CommandKind::kSet, Arguments::kNameAndNumbers},
    {"begin", CommandKind::kBegin, Arguments::kStep},
    {"stop", CommandKind::kStop, Arguments::kNone},
    {"undo", CommandKind::kUndo, Arguments::kNone},
    {"saved", CommandKind::kSaved, Arguments::kNone},
    {"before", CommandKind::kBefore, Arguments::kNone},
    {"defaults", CommandKind::kDefaults, Arguments::kNone},
    {"save", CommandKind::kSave, Arguments::kNone},
    {"exposure", CommandKind::kExposure, Arguments::kNumber},
    {"look", CommandKind::kLook, Arguments::kNone},
    {"return", CommandKind::kReturn, Arguments::kNumber},
};

// Removes the first word from the front of `text` and returns it.
std::string_view SplitWord(std::string_view& text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  const std::string_view word = text.substr(0, text.find(' '));
  text.remove_prefix(word.size());
  return word;
}

// Removes the first word and reads all of it as a number.
template <class T>
bool SplitNumber(std::string_view& text, T& into) {
  const auto number = ParseNumber<T>(SplitWord(text));
  if (number) into = *number;
  return number.has_value();
}

// A position in parts of the picture; both of its edges are in it.
bool IsShare(float value) {
  return value >= 0 && value <= 1;
}

// Numbers must be finite, and positions within the picture: what is done with them need not look any more.
bool ParseArguments(std::string_view& text, Arguments arguments, Command& into) {
  const bool named = arguments == Arguments::kStep || arguments == Arguments::kNameAndNumbers;
  if (named) into.name = SplitWord(text);
  if (named && into.name.empty()) return false;
  if (arguments == Arguments::kStep) return StepNamed(into.name).has_value();
  if (arguments == Arguments::kNone) return true;
  if (!SplitNumber(text, into.a) || !std::isfinite(into.a)) return false;
  if (arguments == Arguments::kNumber) return true;
  if (!SplitNumber(text, into.b) || !std::isfinite(into.b)) return false;
  return arguments != Arguments::kPosition || (IsShare(into.a) && IsShare(into.b));
}

// Writes a packet from its first word to its last.
class PacketWriter {
 public:
  explicit PacketWriter(std::uint32_t kind) { Put(kind); }
  void Put(std::uint32_t word) {
    bytes_.resize(bytes_.size() + 4);
    wire::PutU32(bytes_, bytes_.size() - 4, word);
  }
  void Put(float value) { Put(std::bit_cast<std::uint32_t>(value)); }
  // The length and then the bytes. The cut at kMaxComplaint may fall within a letter of UTF-8.
  void Put(std::string_view text) {
    text = text.substr(0, kMaxComplaint);
    Put(static_cast<std::uint32_t>(text.size()));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
  }
  std::vector<std::uint8_t> Release() { return std::move(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
};

// Reads a packet from its first word to its last. What is missing reads as 0, and `whole` is false then.
class PacketReader {
 public:
  explicit PacketReader(std::span<const std::uint8_t> bytes) : left_(bytes) {}
  // Each takes its bytes off the front; a packet that ends early is noted and never read beyond its end.
  std::uint32_t Word() {
    if (left_.size() < 4) return Missing();
    const std::uint32_t word = wire::GetU32(left_, 0);
    left_ = left_.subspan(4);
    return word;
  }
  // NaN and infinity read as 0 and make the whole packet unreadable, so that nobody behind has to look for
  // them.
  float Value() {
    const auto value = std::bit_cast<float>(Word());
    whole_ = whole_ && std::isfinite(value);
    return std::isfinite(value) ? value : 0;
  }
  std::string Text() {
    const std::uint32_t size = Word();
    if (size > left_.size() || size > kMaxComplaint) return Missing(), std::string();
    std::string text(reinterpret_cast<const char*>(left_.data()), size);
    left_ = left_.subspan(size);
    return text;
  }
  bool whole() const { return whole_ && left_.empty(); }

 private:
  std::uint32_t Missing() {
    whole_ = false;
    return 0;
  }
  std::span<const std::uint8_t> left_;
  bool whole_ = true;
};

}  // namespace

// Arguments stand in the order in which ParseArguments reads them.
std::string CommandText(const Command& command) {
  const auto* verb = std::ranges::find(kVerbs, command.kind, &Verb::kind);
  std::string text = fmt::format("{} {}", command.number, verb->word);
  if (!command.name.empty()) text += " " + command.name;
  if (verb->arguments == Arguments::kPosition || verb->arguments == Arguments::kNameAndNumbers)
    return text + fmt::format(" {} {}", command.a, command.b);
  return verb->arguments == Arguments::kNumber ? text + fmt::format(" {}", command.a) : text;
}

// Words after the last argument are a fault, as unknown verbs are: a desk of another version is to be
// noticed.
Result<Command> ParseCommand(std::string_view text) {
  Command command;
  if (text.size() > kMaxCommandBytes)
    return FailInput(fmt::format("a command has at most {} bytes", kMaxCommandBytes));
  // Not even at the end: a name with a line end in it would be written into logs and settings as two lines.
  if (std::ranges::any_of(text, [](unsigned char each) { return each < 0x20 || each == 0x7F; }))
    return FailInput("a command has no control characters");
  if (!SplitNumber(text, command.number)) return FailInput("a command begins with its number");
  const std::string word(SplitWord(text));
  const auto* verb = std::ranges::find(kVerbs, word, &Verb::word);
  if (verb == std::end(kVerbs)) return FailInput(fmt::format("there is no command \"{}\"", word));
  command.kind = verb->kind;
  if (!ParseArguments(text, verb->arguments, command) || !SplitWord(text).empty())
    return FailInput(fmt::format("the arguments of \"{}\" are wrong", word));
  return command;
}

// In the order of the enumerators, which are the bits of Report::done.
std::string_view NameOf(CalibrationStep step) {
  constexpr std::array<std::string_view, kStepCount> kNames{"shut", "open", "wide", "narrow", "speak"};
  return kNames[static_cast<std::size_t>(step)];
}

std::optional<CalibrationStep> StepNamed(std::string_view name) {
  for (std::size_t n = 0; n < kStepCount; ++n) {
    const auto step = static_cast<CalibrationStep>(n);
    if (NameOf(step) == name) return step;
  }
  return std::nullopt;
}

// The size of the shared memory is in it, so that both ends agree on slots.
std::vector<std::uint8_t> HelloPacket() {
  PacketWriter packet(kHello);
  packet.Put(kPictureSlots * kPictureSlotBytes);
  return packet.Release();
}

// A hello with another size of shared memory comes from lips with other slots, and is none.
bool IsHello(std::span<const std::uint8_t> packet) {
  return packet.size() == kHelloBytes && wire::GetU32(packet, 0) == kHello &&
         wire::GetU32(packet, 4) == kPictureSlots * kPictureSlotBytes;
}

// In the order that protocol.h lists.
std::vector<std::uint8_t> Packet(const Report& report) {
  PacketWriter packet(kReport);
  packet.Put(report.answered);
  packet.Put(report.complaint);
  packet.Put(report.step ? static_cast<std::uint32_t>(*report.step) : kNoStep);
  packet.Put(report.progress);
  packet.Put(report.done);
  packet.Put(report.changes);
  packet.Put((report.unsaved ? 1U : 0U) | (report.saved ? 2U : 0U) | (report.before ? 4U : 0U) |
             (report.exposure_free ? 8U : 0U));
  for (const float value : report.values) packet.Put(value);
  for (const float side : report.box) packet.Put(side);
  return packet.Release();
}

// Values are read in the order in which Packet writes them; shares are clamped, all else is refused where it
// is not finite or not known.
std::optional<Report> ReadReport(std::span<const std::uint8_t> packet) {
  PacketReader reading(packet);
  if (reading.Word() != kReport) return std::nullopt;
  Report report;
  report.answered = reading.Word();
  report.complaint = reading.Text();
  const std::uint32_t step = reading.Word();
  if (step < kStepCount) report.step = static_cast<CalibrationStep>(step);
  report.progress = std::clamp(reading.Value(), 0.0F, 1.0F);
  report.done = reading.Word();
  report.changes = reading.Word();
  const std::uint32_t flags = reading.Word();
  report.unsaved = (flags & 1U) != 0;
  report.saved = (flags & 2U) != 0;
  report.before = (flags & 4U) != 0;
  report.exposure_free = (flags & 8U) != 0;
  for (float& value : report.values) value = reading.Value();
  for (float& side : report.box) side = std::clamp(reading.Value(), 0.0F, 1.0F);
  const bool known = step < kStepCount || step == kNoStep;
  return reading.whole() && known ? std::optional(report) : std::nullopt;
}

// The slot is the desk's from the moment at which this packet is sent.
std::vector<std::uint8_t> Packet(const PictureNote& note) {
  PacketWriter packet(kPicture);
  for (const std::uint32_t word : {note.slot, note.number, note.width_px, note.height_px}) packet.Put(word);
  return packet.Release();
}

// A note that fits can be read without a look at the shared memory's size.
std::optional<PictureNote> ReadPictureNote(std::span<const std::uint8_t> packet) {
  if (packet.size() != kNoteBytes) return std::nullopt;
  PacketReader reading(packet);
  if (reading.Word() != kPicture) return std::nullopt;
  PictureNote note;
  for (std::uint32_t* word : {&note.slot, &note.number, &note.width_px, &note.height_px})
    *word = reading.Word();
  const bool fits = note.slot < kPictureSlots && note.width_px > 0 && note.height_px > 0 &&
                    note.width_px <= kPictureMaxWidth_px && note.height_px <= kPictureMaxHeight_px;
  return fits ? std::optional(note) : std::nullopt;
}

}  // namespace kaori::lips
