"""Makes a library of another's name and symbols, without what it does."""

import subprocess
import tempfile
from pathlib import Path


def symbols(path, which, arch):
    """name -> (kind, version) of a library's symbols; `which` as nm has it: defined or undefined."""
    shown = subprocess.run([arch.tool("nm"), "-D", f"--{which}-only", path], capture_output=True, text=True, check=True).stdout
    found = {}
    for line in shown.splitlines():
        kind, name = line.split()[-2:]
        name, _, version = name.partition("@")
        found[name] = (kind, version.lstrip("@"))
    return found


def asked_of(original, users, arch):
    """What the users take from the original library."""
    asked = {name for user in users for name in symbols(user, "undefined", arch)}
    return {name: what for name, what in sorted(symbols(original, "defined", arch).items()) if name in asked}


def versions(asked):
    """The linker's script: which symbol has which version."""
    names = {}
    for name, (_, version) in asked.items():
        if version:
            names.setdefault(version, []).append(name)
    return "".join(f"{version} {{ global: {'; '.join(names[version])}; }};\n" for version in sorted(names))


def make(original, users, target, arch):
    """A function ends the program; a variable is null. `arch` is the processor of all of them."""
    asked = asked_of(original, users, arch)
    code = "".join(f"void {name}(void) {{ __builtin_trap(); }}\n" if kind in "TW" else f"void* {name};\n"
                   for name, (kind, _) in asked.items())
    with tempfile.TemporaryDirectory() as folder:
        script = Path(folder) / "versions"
        script.write_text(versions(asked))
        command = [arch.tool("gcc"), "-shared", "-fPIC", "-nostdlib", "-w", "-x", "c", "-", "-o", target, "-s",
                   f"-Wl,-soname,{target.name}", "-Wl,--build-id=none"]
        if script.read_text():
            command.append(f"-Wl,--version-script={script}")
        subprocess.run(command, input=code, text=True, check=True)
