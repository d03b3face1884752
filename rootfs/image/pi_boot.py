"""The partitions from which a Raspberry Pi 4 starts. Its firmware reads autoboot.txt on the first one, and goes by it to the partition of
a slot, which has the firmware's second part, its settings, the kernel, its command line and the device tree (Raspberry Pi's documentation,
"autoboot.txt" and "config.txt").

An update overwrites the partition of one slot as a whole, and the one sector of autoboot.txt, in which the slot stands that starts. The
files of the maker's come from a folder that whoever builds the image has; none is ours, and their licence goes along with them.
"""

import os
import shutil
import subprocess
from pathlib import Path

import fat

MIB = 1 << 20
SLOTS = ("a", "b")
# Of the table: "boot" is the first, and a slot's partition has this number there. drivers/loader/tryboot.h has them too.
NUMBERS = {"a": 2, "b": 3}
BOOT_MIB = 40  # The least in which a FAT32 has clusters of one sector, as drivers/loader reads it, with some to spare.
SLOT_MIB = 24  # What drivers/loader/boot_partition.h takes for a slot's kernel with all that goes with it.
AUTOBOOT = "autoboot.txt"
AUTOBOOT_BYTES = 512  # The firmware reads no more, and an update writes it by one sector.
VOLUME_IDS = {"boot": "6B616F73", "a": "6B616F74", "b": "6B616F75"}
KERNEL, TREE = "kernel.img", "bcm2711-rpi-4-b.dtb"  # The second is the name by which the firmware asks.
# No rainbow, no text and no waiting; nothing is looked for that the kernel finds itself.
CONFIG = """# A Kaori box. An update writes this partition as a whole: what is changed here is lost with it.
arm_64bit=1
kernel={kernel}
disable_splash=1
disable_overscan=1
boot_delay=0
auto_initramfs=0
camera_auto_detect=0
display_auto_detect=0
"""


def run(*command):
    return subprocess.run([str(c) for c in command], check=True, capture_output=True, text=True).stdout


def autoboot(slot):
    """The text of autoboot.txt that has a slot start by itself, and the other one where it is to be tried."""
    other = SLOTS[1 - SLOTS.index(slot)]
    return f"[all]\ntryboot_a_b=1\nboot_partition={NUMBERS[slot]}\n[tryboot]\nboot_partition={NUMBERS[other]}\n"


def make_volume(image, size_mib, bits, key, folder):
    """A FAT with the files of a folder, each with the image's date, in clusters of one sector."""
    image.unlink(missing_ok=True)
    run("mkfs.vfat", "--invariant", "-F", bits, "-s", "1", "-n", "KAORI", "-i", VOLUME_IDS[key], "-C", image, size_mib * MIB // 1024)
    date = int(os.environ["SOURCE_DATE_EPOCH"])
    for path in sorted(folder.iterdir()):
        os.utime(path, (date, date))
        run("mcopy", "-m", "-i", image, path, f"::/{path.name}")


def is_one_sector(image):
    """Whether autoboot.txt lies as an update changes it."""
    with open(image, "rb") as file:
        sectors, size = fat.find(file, *AUTOBOOT.split("/"))
    return len(sectors) == 1 and size <= AUTOBOOT_BYTES


def fill_slot(out, board, firmware, kernel, command_line, folder):
    """Everything that the partition of one slot holds."""
    for name in (*board.firmware, board.licence):
        shutil.copyfile(Path(firmware) / name, folder / name)
    shutil.copyfile(kernel, folder / KERNEL)
    shutil.copyfile(out / TREE, folder / TREE)
    (folder / "config.txt").write_text(CONFIG.format(kernel=KERNEL))
    (folder / "cmdline.txt").write_text(command_line)


def room_fault(folder):
    """Why a slot's files do not go into its partition, in one line; None where they do."""
    needed = sum(-(-path.stat().st_size // fat.SECTOR) * fat.SECTOR for path in folder.iterdir())
    room = SLOT_MIB * MIB - MIB  # Tables and the folder at the root take some.
    return None if needed <= room else f"the kernel with all that goes with it has {needed} bytes; a slot has room for {room}"


def make(out, board, firmware, kernel, command_lines):
    """{partition: its content}, in OUT, of the kernel and the device tree in OUT and {slot: command line}; slot a starts by itself."""
    made = {}
    for slot in SLOTS:
        folder = out / f"boot/{slot}"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        fill_slot(out, board, firmware, kernel, command_lines[slot], folder)
        if fault := room_fault(folder):
            raise SystemExit(f"image: {fault}")
        made[f"boot-{slot}"] = out / f"boot-{slot}.vfat"
        make_volume(made[f"boot-{slot}"], SLOT_MIB, 16, slot, folder)
    chooser = out / "boot/chooser"
    shutil.rmtree(chooser, ignore_errors=True)
    chooser.mkdir()
    (chooser / AUTOBOOT).write_text(autoboot(SLOTS[0]))
    made["boot"] = out / "boot.vfat"
    make_volume(made["boot"], BOOT_MIB, 32, "boot", chooser)
    if not is_one_sector(made["boot"]):
        raise SystemExit(f"image: {AUTOBOOT} does not lie in one sector of the partition boot")
    return made
