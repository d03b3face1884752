// Which shaders' sources Mesa need not parse, since what they became lies in its store.
#pragma once

#include <filesystem>

namespace kaori::boot {

// `list` is a text: the folder below `root` in which Mesa keeps what it knows, then the names of sources, 40
// digits each, a line each. Makes Mesa's file there, as its disk_cache.c reads it: 8 bytes of a size, then
// 65536 places of 20 bytes, of which a name's first two, little-endian, say its own. False where the list
// cannot be read, or the file be written; one that is not there says nothing. Blocks for the disk of the
// list; `root` lies in memory (/run). A file that is wrong costs time at the first fade, never a picture.
bool TellKnownShaders(const std::filesystem::path& list, const std::filesystem::path& root);

}  // namespace kaori::boot
