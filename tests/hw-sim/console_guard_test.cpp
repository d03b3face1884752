// Who may use the console, on this machine and on a network; and the sound that it sends, packet by packet.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "hw-sim/console/guard.h"
#include "hw-sim/console/sound_packets.h"

namespace kaori::console {
namespace {

TEST(ConsoleGuard, LetsInThePagesItServed) {
  EXPECT_FALSE(GuardFor("")({.host = "127.0.0.1:8080"}));
  EXPECT_FALSE(GuardFor("")(
      {.host = "localhost:8080", .origin = "http://localhost:8080", .fetch_site = "same-origin"}));
  EXPECT_FALSE(GuardFor("")({.host = "127.0.0.1", .fetch_site = "none"}));
}

TEST(ConsoleGuard, KeepsOutNamesThatAreNotThisMachine) {
  for (const char* host : {"", "example.org", "127.0.0.1.example.org", "localhost.example.org:80",
                           "127.0.0.1:80@x", "192.168.0.2:8080", "0.0.0.0:8080", "[::1]:8080"})
    EXPECT_TRUE(GuardFor("")({.host = host})) << host;
}

TEST(ConsoleGuard, KeepsOutPagesOfOtherSites) {
  const std::string_view host = "127.0.0.1:8080";
  for (const char* origin : {"http://example.org", "http://127.0.0.1:8081", "https://127.0.0.1:8080", "null",
                             "http://127.0.0.1:8080.example.org", "http://localhost:8080"})
    EXPECT_TRUE(GuardFor("")({.host = host, .origin = origin})) << origin;
  for (const char* site : {"cross-site", "same-site"})
    EXPECT_TRUE(GuardFor("")({.host = host, .fetch_site = site})) << site;
}

TEST(ConsoleGuard, OnANetworkKnowsTheMachineByItsAddressesAndItsNameOnly) {
  const web::Guard guard = GuardFor("192.168.0.2");
  for (const char* host : {"192.168.0.2:8080", "127.0.0.1:8080", "localhost:8080", "10.0.0.1"})
    EXPECT_FALSE(guard({.host = host})) << host;
  const std::string own = HostFor("0.0.0.0");
  EXPECT_FALSE(guard({.host = own + ":8080"})) << own;
  EXPECT_FALSE(guard({.host = "192.168.0.2:8080", .origin = "http://192.168.0.2:8080"}));
  // A name that somebody's name server gave this machine's address.
  for (const char* host :
       {"", "example.org:8080", "192.168.0.2.example.org", "192.168.0:8080", "192.168.0.2:80@x"})
    EXPECT_TRUE(guard({.host = host})) << host;
  EXPECT_TRUE(guard({.host = "192.168.0.2:8080", .origin = "http://example.org"}));
  EXPECT_TRUE(guard({.host = "192.168.0.2:8080", .fetch_site = "cross-site"}));
}

TEST(ConsoleGuard, OnThisMachineAloneStaysAsItIsWhereThatIsNamed) {
  EXPECT_TRUE(GuardFor("127.0.0.1")({.host = "192.168.0.2:8080"}));
  EXPECT_FALSE(GuardFor("127.0.0.1")({.host = "127.0.0.1:8080"}));
}

TEST(ConsoleSound, IsPackedWithItsLengthAndItsRate) {
  SoundPackets packets;
  packets.Add({{.samples = {1, -2, 3, -4}}, {.samples = {5, -6}}});
  EXPECT_FALSE(packets.ready()) << "three frames are not worth a packet";
  const std::string packet = packets.Next();
  const std::vector<std::uint8_t> bytes(packet.begin(), packet.end());
  ASSERT_EQ(bytes.size(), 8U + 3 * 4);
  EXPECT_EQ(bytes[0], 3);                               // Frames,
  EXPECT_EQ(bytes[4] | bytes[5] << 8, 48000 & 0xFFFF);  // a second's worth of them,
  EXPECT_EQ(static_cast<std::int8_t>(bytes[10]), -2);   // and the first one's right side.
  EXPECT_EQ(packets.Next().size(), 8U) << "what was packed is gone";
}

TEST(ConsoleSound, OfLongAgoIsDropped) {
  SoundPackets packets;
  sim::Loudspeaker::Heard block;
  block.samples.assign(2 * (SoundPackets::kMostFrames + 100), 7);
  packets.Add({block});
  EXPECT_TRUE(packets.ready());
  EXPECT_EQ(packets.Next().size(), 8 + 4 * SoundPackets::kMostFrames);
}

}  // namespace
}  // namespace kaori::console
