#!/usr/bin/env -S python3 -B
"""The disk starts on a PC by itself: uefi.py IMAGE_FOLDER

The machine has UEFI firmware (OVMF) and no kernel but the one on the disk. Tried on three kinds of disk and two kinds of
graphics card. Nothing is said on any line, so the screen is looked at: first the still must come, then it must move.
"""

import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "rootfs/image"))
from qmp import Qmp  # noqa: E402  The image's own.

FIRMWARE = "/usr/share/ovmf/OVMF.fd"
LONGEST_S = 240
NEAR = 12  # Mean difference of two pictures of one face, of 255.
VIRTIO_GPU = ("-vga", "none", "-device", "virtio-gpu-pci,xres=960,yres=540")
PCS = (
    ("virtio disk, virtio graphics", ("-device", "virtio-blk-pci,drive=disk"), VIRTIO_GPU),
    ("SATA disk, VGA", ("-device", "ide-hd,drive=disk"), ("-vga", "none", "-device", "VGA,xres=960,yres=540,edid=on")),
    ("NVMe disk, virtio graphics", ("-device", "nvme,drive=disk,serial=1"), VIRTIO_GPU),
)


def picture(path):
    """Width, height and the bytes of a PPM's pixels."""
    kind, size, _, pixels = path.read_bytes().split(b"\n", 3)
    assert kind == b"P6", kind
    return *map(int, size.split()), pixels


def difference(one, other):
    """Mean, of pixels at the same place in both, whatever their sizes; of 255."""
    total, count = 0, 0
    for y in range(20):
        for x in range(30):
            colours = []
            for width, height, pixels in (one, other):
                # By height, from the middle, as the still is laid over a screen.
                column = width // 2 + (x - 15) * height // 22
                at = 3 * ((y * 2 + 1) * height // 40 * width + min(max(column, 0), width - 1))
                colours.append(pixels[at:at + 3])
            total += sum(abs(a - b) for a, b in zip(*colours))
            count += 3
    return total / count


def start(image, disk, graphics, folder):
    return subprocess.Popen(
        ["qemu-system-x86_64", "-M", "q35", "-accel", "tcg,thread=multi", "-cpu", "Nehalem", "-smp", "2", "-m", "512",
         "-no-reboot", "-display", "none", "-bios", FIRMWARE, *graphics, "-net", "none",
         "-drive", f"file={image / 'kaori.disk'},if=none,id=disk,format=raw,snapshot=on", *disk,
         "-qmp", f"unix:{folder}/qmp,server=on,wait=off", "-serial", "null"])


def await_picture(qmp, folder, wanted, until):
    """The first picture that `wanted` likes; none in time."""
    while time.monotonic() < until:
        time.sleep(0.3)
        shot = Path(folder) / "screen.ppm"
        qmp.screendump(shot)
        now = picture(shot)
        if wanted(now):
            return now
    return None


def plays(image, disk, graphics, keep):
    """Seconds until the still, and until it moved; none for what did not come."""
    still = picture(image / "root/usr/share/kaori/still.ppm")
    with tempfile.TemporaryDirectory() as folder, start(image, disk, graphics, folder) as machine:
        began = time.monotonic()
        try:
            time.sleep(1)
            qmp = Qmp(f"{folder}/qmp")
            lit = await_picture(qmp, folder, lambda now: difference(now, still) < NEAR, began + LONGEST_S)
            lit_s = time.monotonic() - began
            if lit is None:
                return None, None
            moved = await_picture(qmp, folder, lambda now: now[2] != lit[2], began + LONGEST_S)
            moved_s = time.monotonic() - began
            same = moved is not None and difference(moved, still) < NEAR
            return lit_s, moved_s if same else None
        finally:
            if keep:
                qmp.screendump(keep)
            machine.terminate()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("image", type=Path)
    parser.add_argument("--only", type=int, help="one kind of PC, from 0")
    parser.add_argument("--shot", type=Path, help="a picture of the last screen (PNG)")
    args = parser.parse_args()
    failed = 0
    for number, (name, disk, graphics) in enumerate(PCS):
        if args.only not in (None, number):
            continue
        lit_s, moved_s = plays(args.image, disk, graphics, args.shot)
        failed += moved_s is None
        print(f"{'FAIL' if moved_s is None else 'ok  '}  {name}: still after {lit_s and round(lit_s, 1)} s, "
              f"face after {moved_s and round(moved_s, 1)} s", flush=True)
    sys.exit(failed)


main()
