#!/usr/bin/env -S python3 -B
"""Lets the stage compile its shaders once, in QEMU, and keeps them, and the picture of the first face: warm.py OUT
PACKAGES. Results: OUT/shaders/*.foz and still.ppm

Starts a copy of the image that writes shaders to its data partition. They are for a box that draws without a graphics
card, on any processor since 2008. Does nothing where stage, show and packages are those of the shaders that lie there.
"""

import hashlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import pack
from qmp import Qmp

READY = re.compile("Started .*kaori-stage")
LONGEST_S = 240
WRITTEN_S = 12  # From the first face on: the kernel writes what it holds after 5 s at most; see the mount's options.
STAGE, DATA = "usr/lib/systemd/system/kaori-stage.service", "usr/lib/systemd/system/var-lib-kaori.mount"


def stamp(out, packages):
    hashed = hashlib.sha256(packages.with_suffix(".stamp").read_bytes())
    for part in ("root/usr/bin/kaori-stage", "root/usr/share/kaori/kaori.kaori"):
        hashed.update((out / part).read_bytes())
    return hashed.hexdigest()


def change(path, begins, line):
    lines = [line if old.startswith(begins) else old for old in path.read_text().splitlines()]
    path.write_text("\n".join(lines) + "\n")


def writing_copy(out, packages, folder):
    """The image, but for two lines."""
    subprocess.run(["cp", "-a", out / "root", out / "bzImage", folder], check=True)
    change(folder / "root" / STAGE, "Environment=",
           "Environment=MESA_DISK_CACHE_SINGLE_FILE=1 MESA_SHADER_CACHE_DIR=/var/lib/kaori/own")
    change(folder / "root" / DATA, "Options=", "Options=nodev,nosuid,noexec,nodelalloc,commit=1")
    subprocess.run([Path(__file__).with_name("pack.py"), folder, packages, folder / "image.json"], check=True)


def play(folder):
    """Until the first face, and a little longer."""
    told = (folder / "cmdline").read_text().strip() + " console=ttyS0 systemd.log_target=console systemd.show_status=1"
    with subprocess.Popen(
            ["qemu-system-x86_64", "-M", "q35", "-accel", "tcg,thread=multi", "-cpu", "Nehalem", "-smp", "2", "-m", "512",
             "-vga", "none", "-display", "none", "-no-reboot", "-kernel", folder / "bzImage", "-append", told,
             "-drive", f"file={folder / 'kaori.disk'},if=virtio,format=raw,cache=writethrough",
             "-device", "virtio-gpu-pci,xres=960,yres=540", "-serial", f"file:{folder / 'serial'}",
             "-qmp", f"unix:{folder / 'qmp'},server=on,wait=off"],
            stderr=subprocess.DEVNULL) as machine:
        until = time.monotonic() + LONGEST_S
        while machine.poll() is None and time.monotonic() < until:
            if (folder / "serial").exists() and READY.search((folder / "serial").read_text(errors="replace")):
                Qmp(folder / "qmp").screendump(folder / "still.ppm")
                time.sleep(WRITTEN_S)
                break
            time.sleep(0.2)
        machine.kill()


def take_shaders(folder, shaders):
    start_mib = pack.ALIGNED_MIB + sum(size for name, size, _, _ in pack.LAYOUT if name != "data")
    data = folder / "data"
    subprocess.run(["dd", f"if={folder / 'kaori.disk'}", f"of={data}", "bs=1M", f"skip={start_mib}", "status=none"],
                   check=True)
    subprocess.run(["e2fsck", "-fy", data], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    subprocess.run(["debugfs", "-R", f"rdump own {folder}", data], stderr=subprocess.DEVNULL, check=True)
    for name, kept in (("foz_cache.foz", "shaders.foz"), ("foz_cache_idx.foz", "shaders_idx.foz")):
        found = next((folder / "own").rglob(name), None)
        if found is None:
            sys.exit("warm: the stage wrote no shaders")
        shutil.copyfile(found, shaders / kept)


def main():
    out = Path(sys.argv[1])
    packages = Path(sys.argv[2])
    shaders, wanted = out / "shaders", stamp(out, packages)
    if (shaders / "stamp").exists() and (shaders / "stamp").read_text() == wanted:
        return
    shutil.rmtree(shaders, ignore_errors=True)
    shaders.mkdir()
    with tempfile.TemporaryDirectory(dir=out) as folder:
        writing_copy(out, packages, Path(folder))
        play(Path(folder))
        take_shaders(Path(folder), shaders)
        shutil.copyfile(Path(folder) / "still.ppm", shaders / "still.ppm")
    (shaders / "stamp").write_text(wanted)


main()
