#include "appliance/programs/editor/record.h"

#include <cstring>
#include <optional>
#include <string>
#include <utility>

#include "drivers/base/checksum.h"

namespace kaori::editor {
namespace {

// Length and checksum.
constexpr std::size_t kRecordHeadBytes = sizeof(std::uint32_t) + sizeof(std::uint64_t);
constexpr std::uint32_t kRecordMostBytes = 1U << 20U;  // A longer record is no record.
// In bytes, of a name and of an origin; what is longer is cut.
constexpr std::size_t kRecordLongestName = 200;

// Undo and redo say which step by themselves; every other change brings the work as it was after it.
bool CarriesWork(Change change) {
  return change != Change::kUndone && change != Change::kRedone;
}

// The machine's own byte order, which is little-endian wherever the box runs. A journal does not leave its
// box.
template <class T>
void Put(std::vector<std::uint8_t>& into, const T& value) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(&value);
  into.insert(into.end(), bytes, bytes + sizeof value);
}

// Two bytes of length, and then the text without an end.
void PutText(std::vector<std::uint8_t>& into, const std::string& text) {
  const std::size_t length = std::min(text.size(), kRecordLongestName);
  Put(into, static_cast<std::uint16_t>(length));
  into.insert(into.end(), text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length));
}

// In the order that record.h gives.
void PutWork(std::vector<std::uint8_t>& into, const Work& work) {
  Put(into, static_cast<std::int32_t>(work.slot));
  Put(into, work.lids);
  PutText(into, work.name);
  PutText(into, work.origin);
  Put(into, static_cast<std::uint32_t>(work.pulls_m.size()));
  for (const glm::vec3& pull_m : work.pulls_m) Put(into, pull_m);
}

// Takes values off the front; after the first that is not there, all are empty. The lengths in a record are
// not believed: nothing is read or allocated beyond the bytes that are there.
class RecordParser {
 public:
  explicit RecordParser(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  template <class T>
  T Parse() {
    T value{};
    const auto taken = ParseBytes(sizeof value);
    if (!taken.empty()) std::memcpy(&value, taken.data(), sizeof value);
    return value;
  }

  std::string ParseText() {
    const auto taken = ParseBytes(Parse<std::uint16_t>());
    return {reinterpret_cast<const char*>(taken.data()), taken.size()};
  }

  // Too many wanted: all that is left is gone, so that nothing after it is read from the wrong place.
  std::span<const std::uint8_t> ParseBytes(std::size_t count) {
    if (count > bytes_.size()) {
      short_ = true;
      bytes_ = {};
      return {};
    }
    const auto taken = bytes_.first(count);
    bytes_ = bytes_.subspan(count);
    return taken;
  }

  std::size_t left() const { return bytes_.size(); }
  bool whole() const { return !short_; }

 private:
  std::span<const std::uint8_t> bytes_;
  bool short_ = false;
};

// In the order of PutWork. The count of pulls is not believed further than bytes are there.
Work ParseWork(RecordParser& parser) {
  Work work;
  work.slot = parser.Parse<std::int32_t>();
  work.lids = parser.Parse<std::array<float, 2>>();
  work.name = parser.ParseText();
  work.origin = parser.ParseText();
  const auto count = parser.Parse<std::uint32_t>();
  for (std::uint32_t i = 0; i < count && parser.whole(); ++i)
    work.pulls_m.push_back(parser.Parse<glm::vec3>());
  return work;
}

// Bytes that are left over make a record of another version, which is not read either.
std::optional<Record> DecodeOne(std::span<const std::uint8_t> bytes) {
  RecordParser parser(bytes);
  const auto kind = parser.Parse<std::uint8_t>();
  if (!parser.whole() || kind > static_cast<std::uint8_t>(kLastChange)) return std::nullopt;
  Record record{static_cast<Change>(kind), {}};
  if (CarriesWork(record.change)) record.work = ParseWork(parser);
  if (!parser.whole() || parser.left() > 0) return std::nullopt;
  return record;
}

}  // namespace

// The body is made first, since its length and its checksum stand before it.
void Encode(const Record& record, std::vector<std::uint8_t>& into) {
  std::vector<std::uint8_t> body;
  Put(body, static_cast<std::uint8_t>(record.change));
  if (CarriesWork(record.change)) PutWork(body, record.work);
  Put(into, static_cast<std::uint32_t>(body.size()));
  Put(into, Fnv1a(body));
  into.insert(into.end(), body.begin(), body.end());
}

// Stops at the first record that is not whole: what follows it cannot be found, since lengths lead from one
// to the next.
Decoded Decode(std::span<const std::uint8_t> bytes) {
  Decoded decoded;
  while (bytes.size() - decoded.sound_bytes >= kRecordHeadBytes) {
    RecordParser parser(bytes.subspan(decoded.sound_bytes));
    const auto length = parser.Parse<std::uint32_t>();
    const auto checksum = parser.Parse<std::uint64_t>();
    if (length > kRecordMostBytes || length > parser.left()) break;
    const auto body = parser.ParseBytes(length);
    auto record = DecodeOne(body);
    if (Fnv1a(body) != checksum || !record) break;
    decoded.records.push_back(std::move(*record));
    decoded.sound_bytes += kRecordHeadBytes + length;
  }
  return decoded;
}

}  // namespace kaori::editor
