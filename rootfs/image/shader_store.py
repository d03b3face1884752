"""Mesa's store of compiled shaders, as it writes it: one file of entries, and an index of where each begins."""

import struct

MARK = b"\x81FOSSILIZEDB\x00\x00\x00\x06"
KEY_BYTES = 40
HEAD = struct.Struct("<4I")  # How many bytes follow, of what kind, their checksum, how many they were unpacked.
PLACE = struct.Struct("<Q")


# Beside its store Mesa keeps the names of the sources that are in it, each in a place that its first bytes say; a
# source that is not known there is parsed before the store is asked.
KNOWN, KNOWN_HEAD_BYTES, KNOWN_PLACES, SOURCE_BYTES = "index", 8, 1 << 16, 20


def known(index):
    """The names of the sources in it, sorted."""
    wanted = KNOWN_HEAD_BYTES + KNOWN_PLACES * SOURCE_BYTES
    if len(index) != wanted:
        raise ValueError(f"Mesa's {KNOWN} has {len(index)} bytes, not {wanted}")
    names = {index[at:at + SOURCE_BYTES] for at in range(KNOWN_HEAD_BYTES, wanted, SOURCE_BYTES)}
    return sorted(names - {bytes(SOURCE_BYTES)})


def entries(store):
    """key -> (head, bytes) of the whole entries; and whether nothing is left over."""
    found, at = {}, len(MARK)
    if not store.startswith(MARK):
        return found, False
    while at + KEY_BYTES + HEAD.size <= len(store):
        key, begins = store[at:at + KEY_BYTES], at + KEY_BYTES + HEAD.size
        head = HEAD.unpack_from(store, at + KEY_BYTES)
        if begins + head[0] > len(store):
            break
        found[key] = (head, store[begins:begins + head[0]])
        at = begins + head[0]
    return found, at == len(store)


def is_whole(store, index):
    """Whether every entry was written to its end, and stands in the index."""
    found, ends = entries(store)
    listed = {index[at:at + KEY_BYTES]
              for at in range(len(MARK), len(index), KEY_BYTES + HEAD.size + PLACE.size)}
    return ends and bool(found) and listed == set(found)


def in_order(store):
    """The same entries as Mesa would have written them in the order of their keys: the store, and its index."""
    entries_bytes, index = MARK, MARK
    for key, (head, payload) in sorted(entries(store)[0].items()):
        entries_bytes += key
        index += key + HEAD.pack(PLACE.size, *head[1:2], 0, PLACE.size) + PLACE.pack(len(entries_bytes))
        entries_bytes += HEAD.pack(*head) + payload
    return entries_bytes, index
