#!/usr/bin/env python3
"""What is wrong with the layer for OpenEmbedded: layer.py ROOT BUILD [--grammar NODE_MODULES]

Prints "file: fault" for each and exits 1 when there is one. BUILD is a folder in which everything was built; what it installs
is laid beside what the recipe packages. With --grammar the recipes are parsed (grammar.mjs) and the kas files are compared
with kas's schema, which need npm's and Debian's packages."""

import fnmatch
import functools
import hashlib
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import layer_system

LAYER = Path("rootfs/yocto/meta-kaori")
KAS = Path("rootfs/yocto/kas")
RECIPE = LAYER / "recipes-kaori/kaori-box/kaori-box_git.bb"
KAS_SCHEMA = Path("/usr/lib/python3/dist-packages/kas/schema-kas.json")

# As bitbake.conf has them, where /lib is /usr/lib. FILES of the package that is named like the recipe, for programs.
PATHS = {"bindir": "/usr/bin", "datadir": "/usr/share", "systemd_system_unitdir": "/usr/lib/systemd/system",
         "nonarch_base_libdir": "/usr/lib", "nonarch_libdir": "/usr/lib", "PN": "kaori-box"}
USUAL_FILES = ["/usr/bin/*"]


def listed(name):
    """The fields of each line of a file beside this one."""
    lines = Path(__file__).with_name(name).read_text().splitlines()
    return [line.split() for line in lines if line and line[0] != "#"]


def variables(text):
    """Assignments of a recipe, as (name with overrides, value), in order. Functions are left out."""
    text = re.sub(r"(?m)^[\w:]+\(\) \{\n(?:.*\n)*?^\}\n", "", text)
    text = re.sub(r"\\\n\s*", " ", re.sub(r"(?m)^\s*#.*\n", "", text))
    return re.findall(r'(?m)^([\w:${}\[\].-]+?)\s*(?:\?\?=|\?=|:=|\+=|=\+|\.=|=)\s*"([^"\n]*)"', text)


def value_of(text, *names):
    """All that is assigned to variables of these names, overrides and appends included."""
    return " ".join(value for name, value in variables(text) if re.split(r":", name)[0] in names)


def expanded(text):
    return re.sub(r"\$\{(\w+)\}", lambda name: PATHS.get(name[1], name[0]), text)


def options_unknown(root, build):
    cache = (build / "CMakeCache.txt").read_text()
    known = set(re.findall(r"(?m)^([\w-]+):(?!INTERNAL|STATIC)\w+=", cache))
    for option in re.findall(r"-D(\w+)=", (root / RECIPE).read_text()):
        if option not in known:
            yield f"{RECIPE}: cmake knows no option {option}"


def is_native_too(text):
    return "native" in value_of(text, "BBCLASSEXTEND").split()


def names_wanted(text):
    """Recipes and packages that a recipe asks for; where it is built for the machine that builds too, its DEPENDS as `-native` besides."""
    wanted = value_of(text, "DEPENDS", "RDEPENDS", "RRECOMMENDS", "IMAGE_INSTALL", "WKS_FILE_DEPENDS").split()
    for name, value in variables(text):
        if name.startswith("PACKAGECONFIG["):
            wanted += " ".join(value.split(",")[2:5]).split()  # For the build, for the running box, and what is recommended there.
        if is_native_too(text) and name.split(":")[0] == "DEPENDS" and "class-target" not in name:
            wanted += [f"{each}-native" for each in value.split() if not each.endswith("-native")]
    return [name for name in wanted if not name.startswith("${")]


def names_unknown(root):
    recipes = {path: path.read_text() for path in sorted((root / LAYER).glob("recipes-*/*/*.bb"))}
    known = {"kaori-box-boot"} | {path.stem.split("_")[0] for path in recipes}
    known |= {path.stem.split("_")[0] + "-native" for path, text in recipes.items() if is_native_too(text)}
    for name, _, *native in listed("oe_names.txt"):
        known |= {name, f"{name}-native"} if native else {name}
    for path, text in recipes.items():
        yield from (f"{path.relative_to(root)}: nobody is known to have {name}" for name in names_wanted(text) if name not in known)


@functools.cache
def installed(build):
    """What `cmake --install` lays down, as paths of the box."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(["cmake", "--install", str(build), "--prefix", "/usr"], env={**os.environ, "DESTDIR": folder},
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise SystemExit(f"cmake --install {build}: {done.stderr.strip()}")
        return {str(Path(at, name))[len(folder):] for at, _, names in os.walk(folder) for name in names} | \
            {str(Path(at, name))[len(folder):] for at, folders, _ in os.walk(folder) for name in folders
             if Path(at, name).is_symlink()}


def in_a_package(path, patterns):
    return any(fnmatch.fnmatchcase(path, pattern) or path.startswith(pattern.rstrip("/") + "/") for pattern in patterns)


def files_unpackaged(root, build):
    text = (root / RECIPE).read_text()
    paths = installed(build)
    patterns = expanded(value_of(text, "FILES")).split()
    yield from (f"{RECIPE}: no package has {path}" for path in sorted(paths) if not in_a_package(path, USUAL_FILES + patterns))
    yield from (f"{RECIPE}: nothing that is installed is {pattern}" for pattern in patterns
                if not any(in_a_package(path, [pattern]) for path in paths))
    for unit in value_of(text, "SYSTEMD_SERVICE").split():
        file = f"{PATHS['systemd_system_unitdir']}/{unit}"
        if file not in paths:
            yield f"{RECIPE}: {unit} is not installed"
        elif "[Install]" not in (root / "rootfs/overlay" / file.lstrip("/")).read_text():
            yield f"{RECIPE}: {unit} has no [Install], and cannot be enabled"


def users_missing(root):
    text = (root / RECIPE).read_text()
    made = {"root"} | set(re.findall(r"[a-z-]+(?=;|$)", value_of(text, "USERADD_PARAM"))) | set(re.findall(r"[a-z]+(?=;|$)", value_of(text, "GROUPADD_PARAM")))
    for unit in sorted((root / "rootfs/overlay/usr/lib/systemd/system").glob("kaori-*.service")):
        for name in re.findall(r"(?m)^(?:User|Group)=(\S+)", unit.read_text()):
            if name not in made:
                yield f"{RECIPE}: {unit.name} runs as {name}, whom nobody makes"


def licence_changed(root):
    wanted = re.search(r"file://LICENSE;md5=(\w+)", (root / RECIPE).read_text())[1]
    if hashlib.md5((root / "LICENSE").read_bytes()).hexdigest() != wanted:
        yield f"{RECIPE}: LICENSE has changed; look at it, and change its md5"


def disk_differs(root):
    """Slots, sizes and ids are those of the image that we build ourselves; but a Raspberry Pi's first partition holds what its BSP has."""
    sys.path.insert(0, str(root / "rootfs/image"))
    import pack
    wanted = [(size, uuid) for _, size, _, uuid in pack.LAYOUT]
    for wks in sorted((root / LAYER / "wic").glob("*.wks")):
        found = [(int(size), uuid) for size, uuid in re.findall(r"(?m)^part .*--fixed-size (\d+)M\b.*--uuid (\S+)", wks.read_text())]
        is_boards = "bootimg-partition" in wks.read_text()
        if found[is_boards:] != wanted[is_boards:] or len(found) != len(wanted):
            yield f"{wks.relative_to(root)}: its partitions are not those of rootfs/image/pack.py"


def kas_files(root):
    """Faults of the kas files that need no schema: what they include and name is there."""
    for path in sorted((root / KAS).glob("*.yml")):
        text = path.read_text()
        yield from (f"{path.relative_to(root)}: there is no {name}" for name in re.findall(r"(?m)^ +- (\S+\.yml)$", text)
                    if not (path.parent / name).is_file())
        yield from (f"{path.relative_to(root)}: there is no layer {name}" for name in re.findall(r"(?m)^ +(rootfs/\S+):", text)
                    if not (root / name / "conf/layer.conf").is_file())
        image = re.search(r"(?m)^target: (\S+)", text)
        if image and not list((root / LAYER).glob(f"recipes-*/*/{image[1]}.bb")):
            yield f"{path.relative_to(root)}: there is no image {image[1]}"


def grammar(root, modules):
    files = [*sorted((root / LAYER).glob("recipes-*/*/*.bb")), root / LAYER / "conf/layer.conf"]
    done = subprocess.run(["node", Path(__file__).with_name("grammar.mjs"), modules, *files], capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        raise SystemExit(f"the grammar could not be read: {done.stderr.strip()}")
    return done.stdout.splitlines()


def against_schema(root):
    sys.path.append(str(KAS_SCHEMA.parent.parent))
    import jsonschema
    import yaml
    schema = json.loads(KAS_SCHEMA.read_text())
    for path in sorted((root / KAS).glob("*.yml")):
        for error in jsonschema.Draft4Validator(schema).iter_errors(yaml.safe_load(path.read_text())):
            yield f"{path.relative_to(root)}: {error.message}"


def offences(root, build, modules=None):
    yield from options_unknown(root, build)
    yield from names_unknown(root)
    yield from files_unpackaged(root, build)
    yield from users_missing(root)
    yield from licence_changed(root)
    yield from disk_differs(root)
    yield from kas_files(root)
    yield from layer_system.offences(root, installed(build), listed("oe_paths.txt"))
    if modules:
        yield from grammar(root, modules)
        yield from against_schema(root)


def main():
    root, build = (Path(word).resolve() for word in sys.argv[1:3])
    found = list(offences(root, build, sys.argv[4] if sys.argv[3:4] == ["--grammar"] else None))
    print("\n".join(found) or "the layer agrees with what is built")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
