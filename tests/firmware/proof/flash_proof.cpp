#include "tests/firmware/proof/flash_proof.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <vector>

#include "firmware/surface/flash_store.h"
#include "firmware/surface/sha256.h"
#include "firmware/surface/slots.h"
#include "firmware/surface/updater.h"
#include "tests/firmware/proof/nor.h"

namespace kaori::proof {
namespace {

constexpr std::uint32_t kProduct = 0x12090001;
using Bytes = std::vector<std::uint8_t>;

Bytes MakeImage(std::uint32_t version, std::uint32_t round) {
  Dice dice(version * 977 + round + 1);
  Bytes image(5000 + dice.Throw(5000));
  for (auto& byte : image) byte = static_cast<std::uint8_t>(dice.Throw());
  return image;
}

wire::SurfaceImage Describe(const Bytes& image, std::uint32_t version) {
  return {.product = kProduct,
          .length = static_cast<std::uint32_t>(image.size()),
          .version = version,
          .sha256 = surface::Sha256Of(image)};
}

// Sends an image as the box does. False: refused.
bool Send(surface::Updater& updater, const Bytes& image, std::uint32_t version) {
  if (!updater.Begin(Describe(image, version))) return false;
  for (std::uint32_t at = 0; at < image.size(); at += wire::kSurfaceDataBytes) {
    const auto rest = std::span(image).subspan(at);
    if (!updater.Data(at, rest.first(std::min(rest.size(), wire::kSurfaceDataBytes)))) return false;
  }
  return updater.End();
}

// The version that the first stage starts and that is whole; 0: nothing is.
struct Started {
  surface::Slot slot = surface::Slot::kA;
  std::uint32_t version = 0;
};
Started Start(Nor& flash) {
  const auto slot = surface::Choose(flash);
  if (!slot) return {};
  const auto header = surface::ReadHeader(flash, *slot);
  if (!header || !surface::HasItsHash(flash, *slot, header->image)) return {};
  return {*slot, header->image.version};
}

// Starts, updates to a version, starts that and confirms it. False: it did not come so far.
bool UpdateTo(Nor& flash, std::uint32_t version, std::uint32_t round) {
  const Started now = Start(flash);
  surface::Updater updater(flash, {.slot = now.slot, .product = kProduct, .oldest_version = 1});
  updater.Keep();
  if (!Send(updater, MakeImage(version, round), version)) return false;
  const Started next = Start(flash);
  if (next.version != version) return false;
  surface::Keep(flash, next.slot);
  return surface::IsKept(flash, next.slot);
}

constexpr std::array<std::uint8_t, 3> kOld{1, 2, 3};
constexpr std::array<std::uint8_t, 5> kNew{4, 5, 6, 7, 8};

// As a surface leaves the works: version 1 in slot A, confirmed, and an axis calibrated.
void Deliver(Nor& flash, std::uint32_t round) {
  const Bytes image = MakeImage(1, round);
  surface::Updater works(flash, {.slot = surface::Slot::kB, .product = kProduct, .oldest_version = 1});
  flash.Program(surface::At(surface::Slot::kB) + surface::kPageBytes, std::array<std::uint8_t, 4>{});
  Send(works, image, 1);
  surface::Keep(flash, surface::Slot::kA);
  surface::Store(flash, kOld);
}

// What the power is cut in.
void Play(Nor& flash, std::uint32_t round) {
  UpdateTo(flash, 2, round);
  surface::Store(flash, kNew);
  if (flash.is_on()) UpdateTo(flash, 3, round);
}

bool IsStored(const Nor& flash, std::span<const std::uint8_t> bytes) {
  const auto stored = surface::Load(flash);
  return stored && std::ranges::equal(*stored, bytes);
}

void CutOnce(const Nor& delivered, std::uint32_t at, Cut how, std::uint32_t round, FlashProof& proof) {
  Nor flash = delivered;
  flash.CutAt(at, how, at * 31 + round + 1);
  Play(flash, round);
  flash.PowerOn();
  ++proof.cuts;
  const Started now = Start(flash);
  if (now.version == 0) ++proof.dead;
  // From the second start on nothing is as if the cut had not been: the version stays, whether a try was used up or not.
  const Started again = Start(flash);
  if (now.version > 3 || again.version != now.version) ++proof.unexpected;
  if (!IsStored(flash, kOld) && !IsStored(flash, kNew)) ++proof.lost;
  surface::Store(flash, kNew);
  if (!IsStored(flash, kNew)) ++proof.lost;
  if (!UpdateTo(flash, 4, round) || Start(flash).version != 4) ++proof.dead;
  if (flash.faults() != 0) ++proof.unexpected;
}

}  // namespace

std::uint64_t ProveDefects(std::uint32_t flips) {
  Nor sound;
  Deliver(sound, 0);
  Play(sound, 0);
  const Started newest = Start(sound);
  const auto header = surface::ReadHeader(sound, newest.slot);
  if (!header) return flips;
  Dice dice(11);
  std::uint64_t used = 0;
  for (std::uint32_t flip = 0; flip < flips; ++flip) {
    Nor flash = sound;
    const auto mask = static_cast<std::uint8_t>(1U << dice.Throw(8));
    flash.Flip(surface::ImageAt(newest.slot) + dice.Throw(header->image.length), mask);
    if (surface::Choose(flash) == newest.slot) ++used;
    Nor other = sound;
    other.Flip(surface::At(newest.slot) + dice.Throw(56), mask);  // Of its header.
    if (surface::Choose(other) == newest.slot) ++used;
    // The old bytes lie in the first copy, the new ones in the second.
    other.Flip(surface::kStoreAt + surface::kSectorBytes + dice.Throw(10 + kNew.size()), mask);
    if (!IsStored(other, kOld)) ++used;
  }
  return used;
}

std::uint64_t ProveTrials(std::uint32_t rounds) {
  std::uint64_t wrong = 0;
  const auto want = [&](bool right) { wrong += right ? 0 : 1; };
  for (std::uint32_t round = 0; round < rounds; ++round) {
    Nor flash;
    Deliver(flash, round);
    surface::Updater updater(flash, {.slot = surface::Slot::kA, .product = kProduct, .oldest_version = 1});
    const Bytes image = MakeImage(2, round);
    auto other = Describe(image, 2);
    other.sha256[round % other.sha256.size()] ^= 1;
    want(updater.Begin(other) && !updater.Data(1, image) && updater.Data(0, image) && !updater.End());
    want(Start(flash).version == 1);
    want(Send(updater, image, 2));
    // Three tries; in each of them a further image is refused, and the confirmed one stays where it is.
    for (int start = 0; start < 3; ++start) {
      want(Start(flash).version == 2);
      surface::Updater tried(flash, {.slot = surface::Slot::kB, .product = kProduct, .oldest_version = 1});
      want(!Send(tried, MakeImage(3, round), 3) && surface::ReadHeader(flash, surface::Slot::kA));
    }
    for (int start = 0; start < 3; ++start) want(Start(flash).version == 1);
  }
  return wrong;
}

FlashProof ProveCuts(std::uint32_t rounds) {
  FlashProof proof;
  for (std::uint32_t round = 0; round < rounds; ++round) {
    Nor delivered;
    Deliver(delivered, round);
    Nor whole = delivered;
    Play(whole, round);
    const std::uint32_t operations = whole.operations() - delivered.operations();
    if (Start(whole).version != 3) ++proof.dead;
    for (std::uint32_t at = 1; at <= operations; ++at)
      for (const Cut how : {Cut::kBefore, Cut::kHalf, Cut::kAfter}) CutOnce(delivered, at, how, round, proof);
  }
  return proof;
}

}  // namespace kaori::proof
