"""Where the files of a FAT32 partition lie, by its own tables. Of a file system with one sector to the cluster."""

from typing import NamedTuple

SECTOR = 512
ENTRY_BYTES = 32
LAST, USED = 0x0FFFFFF8, 0x0FFFFFFF  # A chain's last entry, and the bits of an entry that count.
LONG_NAME = 0x0F  # An entry that carries a part of a long name, by its attributes.


class Table(NamedTuple):
    """What the first sector says, in sectors."""

    fat_at: int
    fat_sectors: int
    data_at: int
    root: int  # The cluster of the folder at the root.


def table(image):
    """Of an open file; an error where clusters have several sectors, or it is no FAT32."""
    first = read(image, 0, 1)
    if first[510:512] != b"\x55\xaa" or first[13] != 1 or int.from_bytes(first[11:13], "little") != SECTOR or first[22:24] != bytes(2):
        raise ValueError("no FAT32 with one sector of 512 bytes to the cluster")
    reserved, fats = int.from_bytes(first[14:16], "little"), first[16]
    fat_sectors, root = int.from_bytes(first[36:40], "little"), int.from_bytes(first[44:48], "little")
    return Table(reserved, fat_sectors, reserved + fats * fat_sectors, root)


def read(image, sector, count):
    image.seek(sector * SECTOR)
    return image.read(count * SECTOR)


def sectors(image, tables, cluster):
    """The sectors of a chain in order, from its first cluster on."""
    entries = read(image, tables.fat_at, tables.fat_sectors)
    found = []
    while 2 <= cluster < LAST and len(found) * 4 < len(entries):
        found.append(tables.data_at + cluster - 2)
        cluster = int.from_bytes(entries[cluster * 4:cluster * 4 + 4], "little") & USED
    return found


def short_names(image, tables, cluster):
    """{name of eight and three letters, as it stands on the disk: its entry} of a folder."""
    content = b"".join(read(image, sector, 1) for sector in sectors(image, tables, cluster))
    entries = (content[at:at + ENTRY_BYTES] for at in range(0, len(content), ENTRY_BYTES))
    return {entry[:11]: entry for entry in entries if entry[0] not in (0, 0xE5) and entry[11] & LONG_NAME != LONG_NAME}


def find(image, *names):
    """(sectors, bytes) of a file, by the short names of its folders and its own."""
    tables = table(image)
    cluster, size = tables.root, 0
    for name in names:
        stem, _, ending = name.upper().partition(".")
        entry = short_names(image, tables, cluster)[f"{stem:8}{ending:3}".encode()]
        cluster = int.from_bytes(entry[20:22], "little") << 16 | int.from_bytes(entry[26:28], "little")
        size = int.from_bytes(entry[28:32], "little")
    return sectors(image, tables, cluster), size
