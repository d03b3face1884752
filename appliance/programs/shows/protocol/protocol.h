// What kaori-desk asks of kaori-shows and is told: packets over a Unix socket, so that the program which speaks with browsers
// can change nothing of the box by itself. It hands on what a paired visitor wants, and kaori-shows judges that as it judges
// what a stick brings.
//
// From the desk, each a packet of text:
//   take LINE LIST      the line of this number, from 0, of the list of this number: both as the state has them
//   backup              a backup of the box is made; it comes back as the packet NAME with the open file beside it
//   restore NAME        the open file beside the packet is a backup: it is checked and compared, and the list then asks
//   settings\nTEXT      TEXT in place of the whole box.toml: it is checked and compared, and the list then asks
//
// To the desk, at the beginning of a connection and whenever it has changed, one line of JSON, the state:
//   {"list": number, "choices": [text..], "more": number, "notes": [text..], "busy": bool,
//    "said": {"en": text, "ja": text, "refused": bool}, "settings": text or null,
//    "backup": text or null}
// "list" is another number whenever the choices are others; "more" lie on the stick and have no number; "notes" stand below the
// choices, as what a change would change; while it is "busy" nothing is taken; "settings" is null where nothing is known of them; "backup" is the name of the one that
// this desk got last.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "drivers/base/unique_fd.h"

namespace kaori::shows {

// Where kaori-shows listens while the service key is on.
inline constexpr const char* kDeskSocket = "/run/kaori-shows/desk";

// Of a request: settings are 64 KiB at most (settings_check.h), and there is a word before them.
inline constexpr std::size_t kLongestRequest_bytes = (std::size_t{64} << 10U) + 64;
// Of a state: what a Unix socket takes as one packet, with room for the kernel's own part.
inline constexpr std::size_t kLongestState_bytes = std::size_t{144} << 10U;

struct Request {
  enum class Kind : std::uint8_t { kTake, kBackup, kRestore, kSettings } kind = Kind::kTake;
  std::uint32_t line = 0, list = 0;
  std::string text{};  // Of the settings; of a restore the name.
  UniqueFd file{};     // Of a restore; it comes beside the packet.
};

// Nothing for another text. The file is not there yet. Pure.
std::optional<Request> ParseRequest(std::string_view packet);

}  // namespace kaori::shows
