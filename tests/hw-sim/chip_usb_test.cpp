// The emulated chip as a USB device, with a peer in the emulator's place that says what a chip would.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>
#include <thread>

#include "firmware/wire/bytes.h"
#include "hw-sim/chip/chip_usb.h"

namespace kaori::sim {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;

constexpr Time kBegin{std::chrono::seconds(1)};

// Listens where the emulator would, and answers on a thread of its own.
class EmulatorPeer {
 public:
  EmulatorPeer() : path_(::testing::TempDir() + "chip-" + std::to_string(::getpid())) {
    std::filesystem::remove(path_);
    listener_ = UniqueFd(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_un address{.sun_family = AF_UNIX, .sun_path = {}};
    path_.copy(address.sun_path, sizeof address.sun_path - 1);
    EXPECT_EQ(::bind(listener_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(::listen(listener_.get(), 1), 0);
  }
  ~EmulatorPeer() { std::filesystem::remove(path_); }

  // Answers with these frames, one for each setup that comes, and then leaves the socket open.
  std::unique_ptr<ChipUsb> Connect(const std::vector<UsbBytes>& answers) {
    std::thread peer([&] {
      socket_ = UniqueFd(::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC));
      for (const UsbBytes& answer : answers) {
        Next();
        Say('A', answer);
      }
    });
    auto chip = ChipUsb::Connect(path_);
    peer.join();
    return chip ? std::move(*chip) : nullptr;
  }
  // Kind and bytes of the next frame.
  std::pair<char, UsbBytes> Next() {
    UsbBytes head(3);
    EXPECT_EQ(::recv(socket_.get(), head.data(), head.size(), MSG_WAITALL), 3);
    UsbBytes bytes(wire::GetU16(head, 1));
    if (!bytes.empty()) ::recv(socket_.get(), bytes.data(), bytes.size(), MSG_WAITALL);
    return {static_cast<char>(head[0]), bytes};
  }
  void Say(char kind, const UsbBytes& bytes) {
    UsbBytes frame(3);
    frame[0] = static_cast<std::uint8_t>(kind);
    wire::PutU16(frame, 1, static_cast<std::uint16_t>(bytes.size()));
    frame.insert(frame.end(), bytes.begin(), bytes.end());
    // Byte by byte, as a stream may cut it.
    for (const std::uint8_t byte : frame) EXPECT_EQ(::send(socket_.get(), &byte, 1, 0), 1);
  }
  void HangUp() { socket_.reset(); }

 private:
  std::string path_;
  UniqueFd listener_, socket_;
};

// As the firmware says them, each after the 1 of an answer.
const UsbBytes kDevice{1, 18, 1, 0, 2, 0, 0, 0, 64, 0x09, 0x12, 1, 0, 0, 1, 1, 2, 3, 1};
const UsbBytes kHead{1, 9, 2, 16, 0, 1, 1, 0, 0x80, 150};
const UsbBytes kMaker{1, 6, 3, 'K', 0, 'a', 0}, kName{1, 4, 3, 'D', 0};
const UsbBytes kWhole{1, 9, 2, 16, 0, 1, 1, 0, 0x80, 150, 7, 5, 0x81, 3, 64, 0, 1};

class ChipOnACable : public ::testing::Test {
 protected:
  ChipOnACable() : chip_(peer_.Connect({kDevice, kHead, kMaker, kName, kWhole})) {}
  EmulatorPeer peer_;
  std::unique_ptr<ChipUsb> chip_;
};

TEST_F(ChipOnACable, IsWhoItSaysItIs) {
  ASSERT_NE(chip_, nullptr);
  EXPECT_EQ(chip_->descriptors().speed, UsbSpeed::kFull);
  EXPECT_EQ(chip_->descriptors().vendor, 0x1209);
  EXPECT_EQ(chip_->descriptors().release_bcd, 0x0100);
  EXPECT_EQ(chip_->descriptors().maker, "Ka");
  EXPECT_EQ(chip_->descriptors().name, "D");
  EXPECT_EQ(chip_->descriptors().configuration, UsbBytes(kWhole.begin() + 1, kWhole.end()));
}

TEST_F(ChipOnACable, ItsReportsComeOneForEachPollAndNoMoreThanFiveHundredASecond) {
  ASSERT_NE(chip_, nullptr);
  peer_.Say('I', {1, 2, 3});
  peer_.Say('I', {4});
  EXPECT_THAT(chip_->NextIn(0x81, 2, kBegin), ::testing::Optional(ElementsAre(1, 2)));
  EXPECT_EQ(chip_->next_due(kBegin), kBegin + milliseconds(2));
  EXPECT_EQ(chip_->NextIn(0x81, 64, kBegin + milliseconds(1)), std::nullopt);
  EXPECT_THAT(chip_->NextIn(0x81, 64, kBegin + milliseconds(2)), ::testing::Optional(ElementsAre(4)));
  EXPECT_EQ(chip_->NextIn(0x81, 64, kBegin + milliseconds(4)), std::nullopt);
}

TEST_F(ChipOnACable, WhatAnOperatorAndAHostDoReachesTheChip) {
  ASSERT_NE(chip_, nullptr);
  chip_->Turn(7, -256, 500);
  EXPECT_EQ(peer_.Next(), (std::pair{'T', UsbBytes{7, 0, 0xFF, 0xFF, 0xFF, 0xF4, 1, 0, 0}}));
  chip_->Push(31);
  EXPECT_EQ(peer_.Next(), (std::pair{'P', UsbBytes{31}}));
  chip_->Move(1, 4095);
  EXPECT_EQ(peer_.Next(), (std::pair{'X', UsbBytes{1, 0xFF, 0x0F}}));
  chip_->HandleOut(0x01, UsbBytes{1, 0, 0, 0x80});
  EXPECT_EQ(peer_.Next(), (std::pair{'O', UsbBytes{1, 0, 0, 0x80}}));
  chip_->HostCame(0x81);
  EXPECT_EQ(peer_.Next(), (std::pair{'H', UsbBytes{1}}));
  chip_->PowerCycle();
  EXPECT_EQ(peer_.Next(), (std::pair{'B', UsbBytes{}}));
}

TEST_F(ChipOnACable, WhatItStallsStallsAndLampsAreThoseOfItsRegisters) {
  ASSERT_NE(chip_, nullptr);
  peer_.Say('L', {5, 0, 0, 0x80, 2, 0, 0, 0});
  peer_.Say('A', {0});
  // The answer lies there already, as of a request before: it counts for none.
  std::thread peer([&] {
    EXPECT_EQ(peer_.Next().first, 'S');
    peer_.Say('A', {0});
  });
  EXPECT_EQ(chip_->Answer({.type = 0x80, .request = 6, .value = 0x0600, .index = 0, .length = 10}, {}),
            std::nullopt);
  peer.join();
  EXPECT_EQ(chip_->lamps(), 0x80000005U);
  EXPECT_EQ(chip_->restarts(), 2U);
  EXPECT_TRUE(chip_->answers_standard());
}

TEST_F(ChipOnACable, AnEmulatorThatIsGoneStallsAndIsSilent) {
  ASSERT_NE(chip_, nullptr);
  peer_.HangUp();
  EXPECT_EQ(chip_->Answer({.type = 0x80, .request = 6, .value = 0x0100, .index = 0, .length = 18}, {}),
            std::nullopt);
  EXPECT_FALSE(chip_->is_there());
  EXPECT_EQ(chip_->next_due(kBegin), std::nullopt);
  chip_->Push(1);
}

TEST(ChipThatSaysNothing, IsRefused) {
  EmulatorPeer peer;
  EXPECT_EQ(peer.Connect({{0}, {0}}), nullptr);
}

}  // namespace
}  // namespace kaori::sim
