#!/usr/bin/env -S python3 -B
"""Lets the stage compile its shaders once, in QEMU, and keeps them, and the picture of the first face: warm.py ARCHITECTURE OUT
PACKAGES BENCH. Results: OUT/shaders/*.foz, shaders.known and still.ppm

BENCH is the program kaori-bench. Starts a copy of the image that writes both to its data partition, and waits until every drawing of the show was rehearsed.
They are for a box that draws without a graphics card, on any processor since 2008. Made twice they are the same: the still
is the show's first moment, and the shaders stand in the order of their names. Does nothing where stage, show and packages
are those of the shaders that lie there.
"""

import hashlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import architectures
import pack
import shader_store

REHEARSED = re.compile("all drawing is rehearsed")
LONGEST_S = 3600  # On a busy machine; a few minutes else.
LOOK_S = 6
LOOKS_ALIKE = 3  # Mesa writes what it has compiled whenever nothing else is to be done.
UNIT, OWN = "usr/lib/systemd/system/kaori-stage.service", "/var/lib/kaori/own"
WANTED = "usr/lib/systemd/system/kaori.target.wants"
STILL, STORE, INDEX = "still.ppm", "foz_cache.foz", "foz_cache_idx.foz"
TOLD = "sysctl.vm.dirty_writeback_centisecs=100 sysctl.vm.dirty_expire_centisecs=100"


def stamp(out, packages):
    hashed = hashlib.sha256(packages.with_suffix(".stamp").read_bytes())
    for part in ("root/usr/bin/kaori-stage", "root/usr/share/kaori/kaori.kaori"):
        hashed.update((out / part).read_bytes())
    return hashed.hexdigest()


def writing_copy(out, packages, folder, arch):
    """The image, but for what the stage is told, and without other programs."""
    subprocess.run(["cp", "-a", out / "root", out / arch.kernel_file, folder], check=True)
    start = next(line for line in (folder / "root" / UNIT).read_text().splitlines() if line.startswith("ExecStart="))
    for other in (folder / "root" / WANTED).iterdir():
        if other.name != Path(UNIT).name:
            other.unlink()
    words = ("[Service]", "WatchdogSec=0", "TimeoutStartSec=infinity", "ExecStart=", f"{start} --still {OWN}/{STILL}", "Environment=",
             f"Environment=MESA_DISK_CACHE_SINGLE_FILE=1 MESA_SHADER_CACHE_DIR={OWN}")
    told = folder / "root/etc/systemd/system" / f"{Path(UNIT).name}.d" / "warm.conf"
    told.parent.mkdir(parents=True, exist_ok=True)
    told.write_text("\n".join(words) + "\n")
    packing = (Path(__file__).with_name("pack.py"), folder, packages, folder / "image.json", pack.UNWEIGHED, "--arch", arch.name)
    subprocess.run(packing, check=True)


def started(folder, bench, arch):
    """QEMU, with the command line that kaori-bench has for all machines; what is said goes into FOLDER/console.log."""
    command = subprocess.run([bench, "--arch", arch.name, "--image", folder, "--command", folder, "--keep-disk"], check=True, capture_output=True,
                             text=True).stdout.splitlines()
    line = command.index("-append") + 1
    command[line] += " " + TOLD
    return subprocess.Popen([*command, "-device", "virtio-gpu-pci,xres=960,yres=540"], stderr=subprocess.DEVNULL)


def written(folder):
    """What the stage has written so far: the still, the store, and what Mesa knows of it. None where that is not whole."""
    start_mib = pack.ALIGNED_MIB + sum(size for name, size, _, _ in pack.LAYOUT if name != "data")
    data, own = folder / "data", folder / "own"
    shutil.rmtree(own, ignore_errors=True)
    quiet = dict(stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    subprocess.run(["dd", f"if={folder / 'kaori.disk'}", f"of={data}", "bs=1M", "conv=sparse", f"skip={start_mib}"], **quiet)
    subprocess.run(["e2fsck", "-fy", data], **quiet)
    subprocess.run(["debugfs", "-R", f"rdump own {folder}", data], **quiet)
    found = [next(own.rglob(name), None) for name in (STILL, STORE, INDEX)]
    if None in found:
        return None
    still, store, index = (path.read_bytes() for path in found)
    if not shader_store.is_whole(store, index):
        return None
    place = found[1].parent
    names = shader_store.known((place / shader_store.KNOWN).read_bytes())
    return still, store, "".join(f"{line}\n" for line in (place.relative_to(own), *(name.hex() for name in names)))


def play(folder, bench, arch):
    """Until nothing more is written; what there is then."""
    alike, last, until = 0, None, time.monotonic() + LONGEST_S
    with started(folder, bench, arch) as machine:
        while machine.poll() is None and time.monotonic() < until and alike < LOOKS_ALIKE:
            time.sleep(LOOK_S)
            said = (folder / "console.log").read_text(errors="replace") if (folder / "console.log").exists() else ""
            if not REHEARSED.search(said):
                continue
            now = written(folder)
            alike = alike + 1 if now and now == last else 0
            last = now
        machine.kill()
    if alike < LOOKS_ALIKE:
        said = (folder / "console.log").read_text(errors="replace")
        sys.exit(f"warm: the stage did not rehearse to its end:\n{said[-1500:]}")
    return last


def main():
    arch = architectures.NAMED[sys.argv[1]]
    out, packages, bench = Path(sys.argv[2]), Path(sys.argv[3]), sys.argv[4]
    shaders, wanted = out / "shaders", stamp(out, packages)
    if (shaders / "stamp").exists() and (shaders / "stamp").read_text() == wanted:
        return
    shutil.rmtree(shaders, ignore_errors=True)
    shaders.mkdir()
    with tempfile.TemporaryDirectory(dir=out) as folder:
        writing_copy(out, packages, Path(folder), arch)
        still, store, known = play(Path(folder), bench, arch)
    store, index = shader_store.in_order(store)
    for name, content in ((STILL, still), ("shaders.foz", store), ("shaders_idx.foz", index), ("shaders.known", known.encode())):
        (shaders / name).write_bytes(content)
    (shaders / "stamp").write_text(wanted)


main()
