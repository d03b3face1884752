#!/usr/bin/env -S python3 -B
"""How soon the box shows its face, against the usual way: boot.py IMAGE_FOLDER [--rounds 3]

Ours is the image as it ships. The usual way is Debian's kernel with its modules, one large initramfs that holds the same
root without stills and shaders, and a processor with everything that QEMU can emulate; its programs and its show are
ours. Both are started in turn, on a screen of the same size. Figures go to boot.json: from the start of QEMU to the first
light of any picture, and to the first face that GL draws, as shares of the usual way's first face.
"""

import argparse
import os
import shutil
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

from machine import FACE, SCREEN, Machine
from proof import write_report

DEBIAN = "linux-image-6.12-amd64"
MODULES = ("virtio_blk", "crc32c_generic", "crc16", "mbcache", "jbd2", "ext4", "drm", "drm_kms_helper", "drm_shmem_helper", "virtio_dma_buf", "virtio-gpu",
           "usb-common", "usbcore", "xhci-hcd", "xhci-pci", "hid", "usbhid", "hid-generic")
INIT = """#!/bin/busybox sh
/bin/busybox mount -t proc proc /proc
/bin/busybox mount -t sysfs sys /sys
/bin/busybox mount -t devtmpfs dev /dev
for module in $(/bin/busybox cat /modules/order); do /bin/busybox insmod /modules/$module.ko; done
# In ours the first program does this; udev, which would, waits for the stage's first picture.
/bin/busybox chmod 666 /dev/dri/card0
exec /usr/lib/systemd/systemd
"""
LONGEST_S = 900
COLOURS_OF_A_PICTURE = 500  # QEMU's own words on a screen that is not lit have fewer.


def unpacked_debian(folder):
    """Debian's kernel and its modules."""
    run = dict(cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    shown = subprocess.run(["apt-cache", "depends", DEBIAN], capture_output=True, text=True, check=True).stdout
    package = next(line.split()[-1] for line in shown.splitlines() if "Depends: linux-image" in line)
    subprocess.run(["apt-get", "download", package, "busybox-static"], **run)
    for archive in folder.glob("*.deb"):
        subprocess.run(["dpkg-deb", "-x", archive, folder], **run)
    return next((folder / "boot").glob("vmlinuz-*"))


def usual_initramfs(image, debian, folder):
    root = folder / "initramfs"
    subprocess.run(["cp", "-a", image / "root", root], check=True)
    for name in ("still.ppm", "shaders.foz", "shaders_idx.foz", "shaders.known"):
        (root / "usr/share/kaori" / name).unlink()
    shutil.copy(debian / "bin/busybox", root / "usr/bin/busybox")
    (root / "modules").mkdir()
    found = {path.name.split(".ko")[0]: path for path in debian.rglob("*.ko*")}
    for name in MODULES:
        if found[name].suffix == ".xz":
            (root / "modules" / f"{name}.ko").write_bytes(subprocess.check_output(["xz", "-dc", found[name]]))
        else:
            shutil.copy(found[name], root / "modules")
    (root / "modules/order").write_text("\n".join(MODULES) + "\n")
    (root / "init").write_text(INIT)
    (root / "init").chmod(0o755)
    names = subprocess.check_output(["find", ".", "-print0"], cwd=root)
    packed = subprocess.check_output(["cpio", "--null", "-o", "-H", "newc", "--quiet"], cwd=root, input=names)
    archive = folder / "initramfs.zst"
    archive.write_bytes(subprocess.check_output(["zstd", "-q", "-9", "-T2", "-c"], input=packed))
    shutil.rmtree(root)
    return archive


def is_lit(box):
    try:
        width, height, pixels = box.screen()
    except (OSError, RuntimeError, ValueError):
        return False
    seen = {pixels[at:at + 3] for at in range(0, width * height * 3, 3 * 17)}
    return len(seen) > COLOURS_OF_A_PICTURE


def timed(box, began):
    """Seconds from the start to the first light and to the first face."""
    light = face = None
    while face is None:
        if time.monotonic() - began > LONGEST_S or box.process.poll() is not None:
            raise SystemExit("boot: the face did not come:\n" + box.said()[-3000:])
        time.sleep(0.1)
        if light is None and is_lit(box):
            light = time.monotonic() - began
        if box.wait_for(FACE, 0.01):
            face = time.monotonic() - began
    return light or face, face


def usual_image(image, folder):
    """A folder like an image's, with the usual kernel, and its large initramfs."""
    debian, usual = folder / "debian", folder / "usual"
    debian.mkdir()
    usual.mkdir()
    shutil.copy(unpacked_debian(debian), usual / "bzImage")
    (usual / "cmdline").write_text("rdinit=/init quiet loglevel=3\n")
    (usual / "kaori.disk").symlink_to((image / "kaori.disk").resolve())
    return usual, usual_initramfs(image, debian, folder)


def run(image, more=()):
    began = time.monotonic()
    with Machine(image, screen=(*SCREEN, *more)) as box:
        return timed(box, began)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("image", type=Path)
    parser.add_argument("--rounds", type=int, default=3)
    args = parser.parse_args()
    lights, faces, usual = [], [], []
    with tempfile.TemporaryDirectory(dir=os.environ.get("TMPDIR", "/var/tmp")) as folder:
        stock, initramfs = usual_image(args.image, Path(folder))
        for number in range(args.rounds):
            light, face = run(args.image)
            _, usually = run(stock, ("-cpu", "max", "-m", "2048", "-initrd", str(initramfs)))
            lights.append(light)
            faces.append(face)
            usual.append(usually)
            print(f"round {number + 1}: first light {light:.1f} s, first face {face:.1f} s, usually {usually:.1f} s",
                  flush=True)
    figures = {"first_light_s": statistics.median(lights), "first_face_s": statistics.median(faces),
               "stock_first_face_s": statistics.median(usual),
               # Of each round, since its two starts had the same neighbours.
               "first_light_over_stock": statistics.median(ours / usually for ours, usually in zip(lights, usual)),
               "first_face_over_stock": statistics.median(ours / usually for ours, usually in zip(faces, usual)),
               "boot_rounds": args.rounds}
    figures = {name: round(value, 3) for name, value in figures.items()}
    write_report(args.image, **figures)
    print(figures)


main()
