#!/usr/bin/env python3
"""Makes what is written into a control surface of what the compiler made, and says how large it is.

Usage: images.py BUILD OUT      BUILD holds first.elf and each product's elf. OUT gets, for each product,
                                NAME.bin     the whole flash from its beginning, as a programmer writes it
                                NAME.uf2     the same for a chip whose BOOTSEL button is held
                                NAME.update  an update for a surface that plays: what SurfaceImage says of it, and the image
                                and sizes.json
       images.py --pins         prints the wiring, as docs/firmware.md has it
       images.py --page PAGE    exits 1 where the page has another wiring
"""

import hashlib
import json
import pathlib
import re
import struct
import subprocess
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
TOOL = "arm-none-eabi-"
PRODUCTS = {"dial-box": "wire/dial_box.h", "stick-pod": "wire/stick_pod.h"}
UF2_FAMILY = 0xE48BFF56  # RP2040.
FLASH_AT = 0x10000000
PAGE = 256
STAGE2 = 252
# What a heap would need; none of it may be in an image.
HEAP = re.compile(r"^(malloc|calloc|realloc|free|_sbrk|_Zn[wa]j.*|_Zd[la]Pv.*)$")
CONSTANT = re.compile(r"inline constexpr std::(?:uint16|uint32|size)_t (k\w+) = ([^;]+);")


def constants(header):
    """The named numbers of a header of ours."""
    return {name: eval(value.replace("'", ""), {"__builtins__": {}})  # Products of numbers.
            for name, value in CONSTANT.findall((FOLDER / header).read_text(encoding="utf-8")) if re.fullmatch(r"[\w' *]+", value)}


def rom_checksum(data):
    """CRC-32 as the ROM counts it: highest bit first, begun with ones, not inverted (RP2040 datasheet, 2.8.1.3.1)."""
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte << 24
        for _ in range(8):
            crc = (crc << 1 ^ (0x04C11DB7 if crc & 0x80000000 else 0)) & 0xFFFFFFFF
    return crc


def loaded(elf, *sections):
    """The bytes of an elf's sections, one behind the other."""
    out = elf.with_suffix(".raw")
    subprocess.run([TOOL + "objcopy", "-O", "binary", *(f"--only-section={one}" for one in sections), elf, out], check=True)
    return out.read_bytes()


def ram_bytes(elf):
    """Bytes of RAM that an image takes, code and stack with the rest."""
    listed = subprocess.run([TOOL + "size", "-A", elf], check=True, capture_output=True, text=True).stdout
    return sum(int(size) for name, size in re.findall(r"^(\.\S+)\s+(\d+)\s", listed, re.M)
               if name in (".text", ".data", ".bss", ".stack"))


def heap_names(elf):
    listed = subprocess.run([TOOL + "nm", elf], check=True, capture_output=True, text=True).stdout
    return [line.split()[-1] for line in listed.splitlines() if HEAP.match(line.split()[-1])]


def first_stage(elf, room):
    head = loaded(elf, ".stage2")
    if len(head) > STAGE2:
        sys.exit(f"the second stage has {len(head)} bytes; the ROM takes {STAGE2}")
    head = head.ljust(STAGE2, b"\0")
    stage = head + struct.pack("<I", rom_checksum(head)) + loaded(elf, ".text")
    if len(stage) > room:
        sys.exit(f"the first stage has {len(stage)} bytes; there is room for {room}")
    return stage


def described(image, product, version):
    """SurfaceImage, as firmware/wire/surface_feature.h has it."""
    return struct.pack("<III", product, len(image), version) + hashlib.sha256(image).digest()


def slot_head(description):
    """A slot's header and its record, as firmware/surface/slots.h has them: the first generation, confirmed."""
    head = struct.pack("<4sI", b"KSF1", 1) + description
    head += hashlib.sha256(head).digest()[:4]
    return head.ljust(PAGE, b"\xff") + b"\xff\xff\xff\x00".ljust(PAGE, b"\xff")


def uf2(pieces):
    """UF2 of [(place, bytes)], sector by sector, since the ROM erases each that it comes to."""
    pages = []
    for place, data in pieces:
        data = data.ljust(-(-len(data) // 4096) * 4096, b"\xff")
        pages += [(FLASH_AT + place + at, data[at:at + PAGE]) for at in range(0, len(data), PAGE)]
    return b"".join(struct.pack("<IIIIIIII", 0x0A324655, 0x9E5D5157, 0x2000, at, PAGE, n, len(pages), UF2_FAMILY)
                    + page.ljust(476, b"\0") + struct.pack("<I", 0x0AB16F30) for n, (at, page) in enumerate(pages))


def make(name, header, build, out):
    flash, version = constants("surface/flash.h"), constants("surface/version.h")
    stem = "".join(part.title() for part in name.split("-"))
    ids = constants(header)
    product = ids[f"k{stem}Vendor"] << 16 | ids[f"k{stem}Product"]
    elf = build / f"{name}.elf"
    first = first_stage(build / "first.elf", flash["kFirstStageBytes"])
    image = loaded(elf, ".text", ".data")
    description = described(image, product, version["kVersionMajor"] << 16 | version["kVersionMinor"])
    slot = slot_head(description).ljust(4096, b"\xff") + image
    pieces = [(0, first), (flash["kSlotAAt"], slot), (flash["kSlotBAt"], bytes(PAGE))]  # What lay in slot B is no image.
    whole = bytearray(b"\xff" * (flash["kSlotBAt"] + 4096))
    for place, data in pieces:
        whole[place:place + len(data)] = data
    (out / f"{name}.bin").write_bytes(whole)
    (out / f"{name}.uf2").write_bytes(uf2(pieces))
    (out / f"{name}.update").write_bytes(description + image)
    heap = heap_names(elf)
    if heap:
        sys.exit(f"{name} has a heap: {', '.join(heap)}")
    sizes = {"flash_bytes": len(first) + 2 * PAGE + len(image), "ram_bytes": ram_bytes(elf), "heap_bytes": 0}
    print(f"{name} {version['kVersionMajor']}.{version['kVersionMinor']}: {sizes['flash_bytes']} bytes of flash, of which the first"
          f" stage {len(first)}; {sizes['ram_bytes']} bytes of RAM, code and stack with the rest; no heap")
    return sizes


def pins(name):
    """A product's wiring as a table of Markdown. SPI0 has GPIO 16 to 19, SPI1 10 to 13."""
    text = (FOLDER / "board/rp2040/pins.h").read_text(encoding="utf-8")
    stem = "".join(part.title() for part in name.split("-"))
    table = re.search(rf"k{stem}Pins = .*?}}\);", text, re.S)[0]
    what = {"Input": "in, pull-up", "Output": "out"}
    return "\n".join(["| GPIO | line | way | goes to |", "| --- | --- | --- | --- |",
                      *(f"| {gpio} | {line} | {what.get(use) or f'SPI{int(int(gpio) < 16)}'} | {to} |" for gpio, use, line, to in
                        re.findall(r'\{(\d+), PinUse::k(\w+), "([^"]+)",\s*"([^"]+)"\}', table))])


def main():
    if sys.argv[1:] == ["--pins"]:
        print("\n\n".join(f"{name}\n\n{pins(name)}" for name in PRODUCTS))
        return
    if sys.argv[1] == "--page":
        page = pathlib.Path(sys.argv[2]).read_text(encoding="utf-8")
        other = [name for name in PRODUCTS if pins(name) not in page]
        for name in other:
            print(f"{sys.argv[2]} has not the wiring of {name}; it is\n{pins(name)}")
        sys.exit(1 if other else 0)
    build, out = map(pathlib.Path, sys.argv[1:])
    out.mkdir(parents=True, exist_ok=True)
    sizes = {name: make(name, header, build, out) for name, header in PRODUCTS.items()}
    (out / "sizes.json").write_text(json.dumps(sizes, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
