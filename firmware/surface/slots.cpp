#include "firmware/surface/slots.h"

#include <algorithm>
#include <array>
#include <initializer_list>

#include "firmware/surface/sha256.h"

namespace kaori::surface {
namespace {

constexpr std::uint32_t kMagic = 0x3146534B;  // "KSF1"
// Places of the header and the record, as slots.h draws them.
constexpr std::size_t kImageInHeader = 8;
constexpr std::size_t kCheckInHeader = kImageInHeader + wire::kSurfaceImageBytes;
constexpr std::size_t kCheckBytes = 4;
constexpr std::size_t kKeptInRecord = kTries;
// What erased flash reads as.
constexpr std::uint8_t kUntouched = 0xFF;

// The record has a page of its own: it is programmed while the header beside it must stay as it is.
std::uint32_t RecordAt(Slot slot) {
  return At(slot) + kPageBytes;
}

std::uint8_t RecordByte(const Flash& flash, Slot slot, std::size_t place) {
  return flash.Read(RecordAt(slot), kTries + 1)[place];
}

// Clears one byte of the record; ones in what is programmed leave the others as they are.
void Clear(Flash& flash, Slot slot, std::size_t place) {
  std::array<std::uint8_t, kTries + 1> record;
  record.fill(kUntouched);
  record[place] = 0;
  flash.Program(RecordAt(slot), record);
}

// The tries that a power cut spoilt halfway are used up too.
std::size_t UsedTries(const Flash& flash, Slot slot) {
  std::size_t used = 0;
  while (used < kTries && RecordByte(flash, slot, used) != kUntouched) ++used;
  return used;
}

struct Candidate {
  Slot slot;
  SlotHeader header;
};

}  // namespace

std::uint32_t At(Slot slot) {
  return slot == Slot::kA ? kSlotAAt : kSlotBAt;
}
std::uint32_t ImageAt(Slot slot) {
  return At(slot) + kSectorBytes;
}
Slot Other(Slot slot) {
  return slot == Slot::kA ? Slot::kB : Slot::kA;
}

// The check covers magic, generation and image, so that a header that a power cut left half written, or one
// whose cells have aged, is none. Lengths are looked at before anybody reads so far.
std::optional<SlotHeader> ReadHeader(const Flash& flash, Slot slot) {
  const auto bytes = flash.Read(At(slot), kPageBytes);
  if (wire::GetU32(bytes, 0) != kMagic) return std::nullopt;
  const Sha256Digest check = Sha256Of(bytes.first(kCheckInHeader));
  if (!std::ranges::equal(bytes.subspan(kCheckInHeader, kCheckBytes), std::span(check).first(kCheckBytes)))
    return std::nullopt;
  const SlotHeader header{
      .generation = wire::GetU32(bytes, 4),
      .image = wire::DecodeSurfaceImage(bytes.subspan<kImageInHeader, wire::kSurfaceImageBytes>())};
  if (header.image.length == 0 || header.image.length > kMostImageBytes) return std::nullopt;
  return header;
}

// One page is programmed and none erased: the slot's first sector must be blank. A cut within it leaves a
// header whose check fails, which counts as none.
void WriteHeader(Flash& flash, Slot slot, const SlotHeader& header) {
  std::array<std::uint8_t, kCheckInHeader + kCheckBytes> bytes{};
  wire::PutU32(bytes, 0, kMagic);
  wire::PutU32(bytes, 4, header.generation);
  std::ranges::copy(wire::Encode(header.image), bytes.begin() + kImageInHeader);
  const Sha256Digest check = Sha256Of(std::span(bytes).first<kCheckInHeader>());
  std::ranges::copy(std::span(check).first(kCheckBytes), bytes.begin() + kCheckInHeader);
  flash.Program(At(slot), bytes);
}

std::span<const std::uint8_t> Image(const Flash& flash, Slot slot, const wire::SurfaceImage& image) {
  return flash.Read(ImageAt(slot), image.length);
}

// Reads the whole image, 240 KiB at most. The first stage does so at each start.
bool HasItsHash(const Flash& flash, Slot slot, const wire::SurfaceImage& image) {
  return Sha256Of(Image(flash, slot, image)) == image.sha256;
}

bool IsKept(const Flash& flash, Slot slot) {
  return RecordByte(flash, slot, kKeptInRecord) == 0;
}

void Keep(Flash& flash, Slot slot) {
  if (!IsKept(flash, slot)) Clear(flash, slot, kKeptInRecord);
}

// The newest whole image, unless it was tried three times without saying that it is well; then the one
// before. Where both have used up their tries the newest is started all the same: a box that may not play is
// worse than one that tries again. A try is written down before it is made, so that an image that hangs
// counts.
std::optional<Slot> Choose(Flash& flash) {
  std::array<Candidate, 2> whole{};
  std::size_t count = 0;
  for (const Slot slot : {Slot::kA, Slot::kB}) {
    const auto header = ReadHeader(flash, slot);
    if (header && HasItsHash(flash, slot, header->image)) whole[count++] = {slot, *header};
  }
  if (count == 0) return std::nullopt;
  // Generations are compared by their distance, so that they may wrap.
  if (count == 2 && static_cast<std::int32_t>(whole[1].header.generation - whole[0].header.generation) > 0)
    std::swap(whole[0], whole[1]);
  for (const Candidate& one : std::span(whole).first(count)) {
    if (IsKept(flash, one.slot)) return one.slot;
    const std::size_t used = UsedTries(flash, one.slot);
    if (used < kTries) {
      Clear(flash, one.slot, used);
      return one.slot;
    }
  }
  return whole[0].slot;
}

}  // namespace kaori::surface
