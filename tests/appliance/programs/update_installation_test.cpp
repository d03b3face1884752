// An update is brought into the other slot whole, or the box says in one line why not.
#include "tests/appliance/programs/update_fixture.h"

namespace kaori::update {
namespace {

using UpdateInstallation = UpdateTest;

// How many altered updates each test tries.
std::size_t AlteredCount() {
  return 200 * Effort();
}

TEST_F(UpdateInstallation, WritesRootTreeAndKernelOfTheOtherSlotAndSaysThatItWaits) {
  const auto progress = Install(BundleOf(6));
  EXPECT_EQ(progress.message, Message::kWaits) << progress.detail;
  EXPECT_EQ(progress.version, 6U);
  EXPECT_FLOAT_EQ(progress.done, 1);
  const auto parts = PartsOf(6);
  EXPECT_EQ(OnDisk(kRootB, kRoot), parts[0]);
  EXPECT_EQ(OnDisk(kVerityB, kVerity), parts[1]);
  EXPECT_EQ(OnDisk(kKernelB, kKernel), parts[3]) << "the kernel of slot B";
  EXPECT_EQ(notes_.pending, (Pending{6, ports::Slot::kB, 0}));
  EXPECT_EQ(OnDisk(kRootA, kRoot), Bytes(kRoot, 0xA1));
}

TEST_F(UpdateInstallation, TakesTheOtherKernelWhereSlotBRuns) {
  running_.slot = ports::Slot::kB;
  ASSERT_EQ(Install(BundleOf(6)).message, Message::kWaits);
  EXPECT_EQ(OnDisk(kKernelB, kKernel), PartsOf(6)[2]);
  EXPECT_EQ(notes_.pending->slot, ports::Slot::kA);
}

TEST_F(UpdateInstallation, TakesTheSameVersionAgain) {
  EXPECT_EQ(Install(BundleOf(5)).message, Message::kWaits);
}

TEST_F(UpdateInstallation, RefusesBeforeAByteIsWritten) {
  const show::SecretKey other_maker = show::MakeKey().value();
  Bytes cut = BundleOf(6);
  cut.resize(cut.size() - 1);
  Bytes flipped = BundleOf(6);
  flipped[kHeader_bytes + 1000] ^= 1U;
  Bytes forged = BundleOf(6);
  forged[12] = 99;
  Bytes newer_form = BundleOf(6);
  newer_form[8] = 2;
  Manifest other = ManifestOf(6), later = ManifestOf(9);
  other.product = "kaori-box-arm64-1";
  later.from = 7;
  const std::vector<std::pair<Bytes, Message>> cases{
      {BundleOf(4), Message::kOlder},
      {BundleOf(2), Message::kBelowLeast},
      {BundleOf(ManifestOf(6), other_maker), Message::kForeign},
      {BundleOf(other, maker_), Message::kOtherProduct},
      {BundleOf(later, maker_), Message::kNewerForm},
      {cut, Message::kCutOff},
      {Bytes(cut.begin(), cut.begin() + 100), Message::kCutOff},
      {Bytes{}, Message::kNotAnUpdate},
      {Bytes(2000, 'x'), Message::kNotAnUpdate},
      {newer_form, Message::kNewerForm},
      {forged, Message::kDamaged},
      {flipped, Message::kDamaged}};
  for (const auto& [bundle, message] : cases) {
    EXPECT_EQ(Install(bundle).message, message) << Words(message, Language::kEnglish);
    EXPECT_TRUE(IsRefusal(message));
    EXPECT_TRUE(disk_.events().empty()) << Words(message, Language::kEnglish);
    EXPECT_TRUE(notes_.changes.empty());
  }
}

// The second root of trust is for the day on which the first one is lost.
TEST_F(UpdateInstallation, OfEachOfTheKeysThatAreTrustedIsTaken) {
  const auto second = show::MakeKey().value();
  EXPECT_EQ(Install(BundleOf(ManifestOf(6), second)).message, Message::kForeign);
  keys_.push_back(second.public_key());
  EXPECT_EQ(Install(BundleOf(ManifestOf(6), second)).message, Message::kWaits);
  EXPECT_EQ(Install(BundleOf(6)).message, Message::kWaits);
}

TEST_F(UpdateInstallation, RefusesWhatDoesNotFitIntoTheSlot) {
  verity_b_ = disk_.Partition(kVerityB, kVerity - 1);
  EXPECT_EQ(Install(BundleOf(6)).message, Message::kTooLarge);
  EXPECT_TRUE(disk_.events().empty());
}

// Half of them in the header, which is small and signed, half in what follows.
TEST_F(UpdateInstallation, OfOneFlippedBitAnywhereWritesNothing) {
  const std::size_t count = AlteredCount();
  Bytes altered = BundleOf(6);
  RecordProperty("altered", static_cast<int>(count));
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t in_header = n * kHeader_bytes / count;
    const std::size_t in_payload = kHeader_bytes + n * (altered.size() - kHeader_bytes) / count;
    std::uint8_t& byte = altered[n % 2 == 0 ? in_header : in_payload];
    const auto bit = static_cast<std::uint8_t>(1U << (n / 2 % 8));
    byte ^= bit;
    EXPECT_TRUE(IsRefusal(Install(altered).message)) << n;
    ASSERT_TRUE(disk_.events().empty()) << n;
    byte ^= bit;
  }
}

TEST_F(UpdateInstallation, ThatIsCutOffAnywhereWritesNothing) {
  const std::size_t count = AlteredCount();
  const Bytes bundle = BundleOf(6);
  RecordProperty("altered", static_cast<int>(count));
  for (std::size_t n = 0; n < count; ++n) {
    Bytes cut = bundle;
    cut.resize(n % 2 == 0 ? n * kHeader_bytes / count : n * bundle.size() / count);
    EXPECT_TRUE(IsRefusal(Install(cut).message)) << n;
    ASSERT_TRUE(disk_.events().empty()) << n;
  }
}

// With the power off in the middle what waited before must not be tried: its slot is half written.
TEST_F(UpdateInstallation, ForgetsWhatWaitedBeforeItsFirstWrite) {
  notes_.pending = Pending{5, ports::Slot::kB, 1};
  auto pulled = std::make_unique<SimulatedSource>(BundleOf(6));
  pulled->readings_left = 4;
  EXPECT_EQ(Install(std::move(pulled)).message, Message::kPulled);
  EXPECT_FALSE(disk_.events().empty());
  EXPECT_EQ(notes_.pending, std::nullopt);
}

// Nothing was written: what lies there is still the system before, which has a hole.
TEST_F(UpdateInstallation, OfAStickThatIsPulledBeforeTheFirstWriteLeavesWhatIsKnownOfTheOtherSlot) {
  const Pending old{2, ports::Slot::kB, 0};
  notes_.before = old;
  auto pulled = std::make_unique<SimulatedSource>(BundleOf(6));
  pulled->readings_left = 2;
  EXPECT_EQ(Install(std::move(pulled)).message, Message::kPulled);
  EXPECT_TRUE(disk_.events().empty());
  EXPECT_EQ(notes_.before, std::nullopt) << "nobody goes back to it, for it may be written in part";
  EXPECT_EQ(notes_.overwritten, old);
  ASSERT_EQ(Install(BundleOf(6)).message, Message::kWaits);
  EXPECT_EQ(notes_.overwritten, std::nullopt) << "it is the update that lies there now";
  EXPECT_EQ(notes_.before, (Pending{5, ports::Slot::kA, 0})) << "who starts it by hand can go back, too";
}

// At each reading once; a whole update has some dozens.
TEST_F(UpdateInstallation, OfAStickThatIsPulledAtAnyReadingLeavesNothingThatWaitsOrStarts) {
  const Bytes kernel = OnDisk(kKernelB, kKernel);
  std::size_t readings = 0;
  for (Message message = Message::kPulled; message == Message::kPulled; ++readings) {
    ASSERT_TRUE(OnDisk(kKernelB, kKernel) == kernel) << "after " << readings << " readings";
    ASSERT_EQ(notes_.pending, std::nullopt);
    auto pulled = std::make_unique<SimulatedSource>(BundleOf(6));
    pulled->readings_left = readings;
    message = Install(std::move(pulled)).message;
    ASSERT_LT(readings, 1000U);
  }
  EXPECT_TRUE(notes_.pending) << "with all of its readings it comes in";
  EXPECT_GE(readings, 5U);
}

TEST_F(UpdateInstallation, FindsAStickThatGivesAnotherFileTheSecondTime) {
  for (const std::uint32_t version : {6U, 7U}) {
    auto other = std::make_unique<SimulatedSource>(BundleOf(6));
    other->readings_left = 2;
    other->then = BundleOf(version);
    EXPECT_EQ(Install(std::move(other)).message, version == 6 ? Message::kWaits : Message::kPulled);
    EXPECT_EQ(notes_.pending.has_value(), version == 6);
  }
}

// Root and verity are those that were promised, so that a foreign kernel on the disk would start with them.
TEST_F(UpdateInstallation, WritesNoByteOfAKernelThatBecameAnotherOneSinceTheFirstReading) {
  const Bytes honest = BundleOf(6);
  SimulatedSource source(honest);
  const Manifest manifest = ReadManifest(source).value();
  const PackedPart kernel = manifest.part(Part::kKernelB);
  const Bytes before = OnDisk(kKernelB, kKernel);
  const std::size_t at = kHeader_bytes + manifest.PackedAt(Part::kKernelB);
  const Bytes foreign = Pack(Noise(kKernel, 99)).value();
  Bytes then = honest;
  std::copy_n(foreign.begin(), std::min<std::size_t>(foreign.size(), kernel.packed_bytes),
              then.begin() + static_cast<std::ptrdiff_t>(at));
  auto liar = std::make_unique<SimulatedSource>(honest);
  liar->readings_left = 2;  // The header, and all of the payload.
  liar->then = std::move(then);
  const Message message = Install(std::move(liar)).message;
  EXPECT_EQ(message, Message::kPulled);
  EXPECT_EQ(OnDisk(kRootB, kRoot), PartsOf(6)[0]) << "it was written that far";
  EXPECT_TRUE(OnDisk(kKernelB, kKernel) == before);
  EXPECT_EQ(notes_.pending, std::nullopt);
}

// What comes again after more than the window's 8 MiB: a larger window would be smaller still, and no box would take it.
TEST_F(UpdateInstallation, PackedAsSmallAsItCanBeIsSmallerAndUnpacksWithinTheSameMemory) {
  constexpr std::size_t kWords = 100'000, kWord_bytes = 7, kKnownWords = 2000,
                        kBetween_bytes = std::size_t{9} << 20U;
  const Bytes letters = Noise(kKnownWords * kWord_bytes, 1), chosen = Noise(2 * kWords, 2);
  Bytes text;
  for (std::size_t n = 0; n < 2 * kWords; n += 2) {
    const std::size_t word = (std::size_t{chosen[n]} * 256 + chosen[n + 1]) % kKnownWords;
    const auto from = letters.begin() + static_cast<std::ptrdiff_t>(word * kWord_bytes);
    text.insert(text.end(), from, from + 2 + static_cast<std::ptrdiff_t>(word % (kWord_bytes - 2)));
  }
  const Bytes once = text;
  text.resize(text.size() + kBetween_bytes);
  text.insert(text.end(), once.begin(), once.end());
  const Bytes quick = Pack(text).value(), smallest = Pack(text, Packing::kSmallest).value();
  EXPECT_LT(smallest.size(), quick.size());
  Bytes unpacked(text.size());
  std::span<const std::uint8_t> packed = smallest;
  EXPECT_EQ(Unpacker().Unpack(packed, unpacked).value(), text.size());
  EXPECT_TRUE(unpacked == text);
}

TEST_F(UpdateInstallation, FindsADiskThatHoldsAnotherThingThanWasWritten) {
  disk_.Rot();
  EXPECT_EQ(Install(BundleOf(6)).message, Message::kDiskFault);
  EXPECT_EQ(notes_.pending, std::nullopt);
}

// Each write fails once; afterwards the same update comes in.
TEST_F(UpdateInstallation, OfADiskThatFailsAtAnyWriteLeavesNothingThatWaits) {
  std::uint64_t writes = 0;
  for (Message message = Message::kDiskFault; message == Message::kDiskFault; ++writes) {
    disk_.FailAfter(writes);
    message = Install(BundleOf(6)).message;
    EXPECT_EQ(notes_.pending.has_value(), message == Message::kWaits);
    ASSERT_LT(writes, 100U);
  }
  EXPECT_GE(writes, 4U);
}

TEST_F(UpdateInstallation, SaysWhenItCannotBeNoted) {
  notes_.fault = std::errc::no_space_on_device;
  EXPECT_EQ(Install(BundleOf(6)).message, Message::kDataFull);
  EXPECT_TRUE(disk_.events().empty()) << "what waits cannot be forgotten, so nothing is written";
  notes_.fault = std::errc::io_error;
  EXPECT_EQ(Install(BundleOf(6)).message, Message::kDiskFault);
  EXPECT_TRUE(disk_.events().empty());
}

TEST_F(UpdateInstallation, WritesNothingWhereTheNoteAtItsEndWouldHaveNoRoom) {
  notes_.no_room = std::errc::no_space_on_device;
  EXPECT_EQ(Install(BundleOf(6)).message, Message::kDataFull);
  EXPECT_TRUE(disk_.events().empty());
  notes_.no_room.reset();
  EXPECT_EQ(Install(BundleOf(6)).message, Message::kWaits);
}

TEST(UpdateMessages, HaveALineInBothLanguagesThatFitsAScreen) {
  for (std::size_t n = 0; n < kMessageCount; ++n) {
    const auto message = static_cast<Message>(n);
    const auto english = Words(message, Language::kEnglish), japanese = Words(message, Language::kJapanese);
    EXPECT_FALSE(english.empty());
    EXPECT_FALSE(japanese.empty());
    EXPECT_LE(english.size(), 90U) << english;
    EXPECT_LE(japanese.size() * 2 / 3, 90U) << japanese;
  }
}

}  // namespace
}  // namespace kaori::update
