"""What of the layer for OpenEmbedded would only show in a system that bitbake made: files that another package has too, a default target
that is none, memory laid over what is kept, a kernel that is not told what to start. Read by layer.py."""

import fnmatch
import re
from pathlib import Path

OVERLAY = Path("rootfs/overlay")
INSTALL = Path("rootfs/install.cmake")
LAYER = Path("rootfs/yocto/meta-kaori")
KAS = Path("rootfs/yocto/kas")
IMAGE = LAYER / "recipes-kaori/images/kaori-box-image.bb"
UNITS = "/usr/lib/systemd/system"
# What an archive's folder is called is its maker's affair; S is ${WORKDIR}/${BP}, or in newer releases ${UNPACKDIR}/${BP}.
UNPACKED = ";subdir=${BP};striplevel=1"


def may_be_installed(root):
    """Paths of the overlay that install.cmake names, also those of a system that is a box and nothing else."""
    paths = set()
    for name in re.findall(r"\$\{overlay\}/([^\s)]+)", (root / INSTALL).read_text()):
        for found in (root / OVERLAY / "usr/lib").glob(name):
            within = found.rglob("*") if found.is_dir() and not found.is_symlink() else [found]
            paths |= {f"/{path.relative_to(root / OVERLAY)}" for path in within if path.is_symlink() or not path.is_dir()}
    return paths


def owned_by_others(root, installed, listed):
    """What is installed must be no file of a package that is in every image."""
    for path in sorted(installed | may_be_installed(root)):
        owners = [owner for pattern, owner in listed if fnmatch.fnmatchcase(path, pattern) and path.count("/") == pattern.count("/")]
        if owners and "kaori" not in Path(path).name:
            yield f"{INSTALL}: {path} is a file of the package {owners[0]}, and would be in two of them"


def value(text, name):
    """Of a variable of bitbake's, the last that is assigned, whatever its overrides; empty where none is."""
    found = re.findall(rf'(?m)^ *{name}(?:[:\w]*) *\??= *"([^"]*)"', text)
    return found[-1] if found else ""


def default_target(root):
    target = value((root / IMAGE).read_text(), "SYSTEMD_DEFAULT_TARGET")
    unit = root / OVERLAY / UNITS.lstrip("/") / (target or "none")
    if not unit.is_file():
        yield f"{IMAGE}: the system starts {target or 'multi-user.target'}, which is no target of the box"
    elif re.search(r"(?m)^(?:Requires|Wants|BindsTo)=.*(?:getty|multi-user|graphical)", unit.read_text()):
        yield f"{IMAGE}: {target} wants what wants a getty"


def laid_over(root):
    """No memory is laid over the data partition, nor over a folder above it."""
    kept = re.search(r"(?m)^Where=(\S+)", (root / OVERLAY / UNITS.lstrip("/") / "var-lib-kaori.mount").read_text())[1]
    text = (root / KAS / "kaori-box.yml").read_text()
    if not value(text, "VOLATILE_BINDS"):
        yield f"{KAS}/kaori-box.yml: VOLATILE_BINDS is not set, whose usual value lays memory over /var/lib"
    for line in value(text, "VOLATILE_BINDS").split("\\n"):
        if len(line.split()) > 1 and f"{kept}/".startswith(f"{line.split()[1].rstrip('/')}/"):
            yield f"{KAS}/kaori-box.yml: VOLATILE_BINDS lays memory over {line.split()[1]}, and so over {kept}"


def command_lines(root):
    """Each machine's kernel starts kaori-boot and authorises no USB device by itself; QEMU's finds the root on the disk's own partition."""
    wks = (root / LAYER / "wic/kaori-box.wks").read_text()
    wanted = set(re.search(r'--append="([^"]*)"', wks)[1].split()) - {"rootwait"}
    emulated = (root / KAS / "qemuarm64.yml").read_text()
    for name, line in (("qemuarm64.yml", value(emulated, "QB_KERNEL_CMDLINE_APPEND")),
                       ("raspberrypi4-64.yml", value((root / KAS / "raspberrypi4-64.yml").read_text(), "CMDLINE"))):
        for word in sorted(wanted - set(line.split())):
            yield f"{KAS}/{name}: the kernel is not told {word}"
    for word in ("init=/usr/bin/kaori-boot", "usbcore.authorized_default=0"):
        if word not in wanted:
            yield f"{LAYER}/wic/kaori-box.wks: the kernel is not told {word}"
    number = [line.split()[1] for line in wks.splitlines() if line.startswith("part ")].index("/") + 1
    for name, right in (("QB_DEFAULT_FSTYPE", "wic"), ("QB_FSINFO", "wic:no-kernel-in-fs"), ("QB_KERNEL_ROOT", f"/dev/vda{number} ro")):
        if value(emulated, name) != right:
            yield f"{KAS}/qemuarm64.yml: {name} is not {right}, with which runqemu finds the root"


def archives(root):
    for path in sorted((root / LAYER / "recipes-support").glob("*/*.bb")):
        uri = value(path.read_text(), "SRC_URI")
        if not uri.endswith(UNPACKED):
            yield f"{path.relative_to(root)}: its archive is not unpacked where S points to; SRC_URI wants {UNPACKED}"


def releases(root):
    """The layer claims the releases that the kas files fetch, and no other."""
    claimed = set(value((root / LAYER / "conf/layer.conf").read_text(), "LAYERSERIES_COMPAT_kaori").split())
    fetched = {name for file in (root / KAS).glob("*.yml") for name in re.findall(r"(?m)^ +refspec: (\S+)", file.read_text())}
    if claimed != fetched:
        yield f"{LAYER}/conf/layer.conf: it claims {' '.join(sorted(claimed))}, and {' '.join(sorted(fetched))} is fetched"


def offences(root, installed, listed):
    yield from owned_by_others(root, installed, listed)
    yield from default_target(root)
    yield from laid_over(root)
    yield from command_lines(root)
    yield from archives(root)
    yield from releases(root)
