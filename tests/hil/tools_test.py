#!/usr/bin/env -S python3 -B
"""Every tool that a script or a check calls is in a package that ./box installs: tools_test.py REPOSITORY

Reads what shell scripts run in command position or lay on the agent's disk, what Python gives to subprocess, what the
simulator's and the tests' C++ starts, and what scripts of Node start: all of the tree but what runs on the box itself. Each name
must be in TOOLS with its package, and the package in one of the lists of ./box (NAME_PACKAGES=(...)) or part of every Debian.
The control: a script with a tool that no list has is found, and so is each way in which C++ starts one.
"""

import ast
import re
import subprocess
import sys
from pathlib import Path

from cpp_tools import cpp_tools

ESSENTIAL = "part of every Debian"
# Tool -> package.
TOOLS = {
    **dict.fromkeys("awk basename cat chmod cksum comm cp cut date dd dirname find flock grep head id install kill ln ls mkdir mktemp "
                    "mv nice nproc paste printf realpath rm sed seq setsid sha256sum sleep sort stat tail tar tee timeout touch "
                    "tr truncate true uname uniq wc xargs bash sh dpkg dpkg-deb dpkg-query apt-get apt-cache env ldd sudo "
                    "readlink unshare mount su sync perl gzip hostname cmp setpriv apt nohup du expr mkfifo /bin/sh".split(), ESSENTIAL),
    "systemd-analyze": "systemd", "python3": "python3", "git": "git",
    "cmake": "cmake", "ctest": "cmake", "ninja": "ninja-build", "make": "make", "patch": "patch", "gcc": "gcc", "g++": "g++", "ccache": "ccache",
    "clang-14": "clang-14", "clang++-14": "clang-14", "clang-tidy-14": "clang-tidy-14", "clang-format-14": "clang-format-14",
    "chromium": "chromium", "node": "nodejs", "npm": "npm", "ffmpeg": "ffmpeg", "ffprobe": "ffmpeg", "shellcheck": "shellcheck",
    "strace": "strace",
    "mmdebstrap": "mmdebstrap", "mkfs.erofs": "erofs-utils", "mke2fs": "e2fsprogs", "e2fsck": "e2fsprogs",
    "debugfs": "e2fsprogs", "veritysetup": "cryptsetup-bin", "sgdisk": "gdisk", "mkfs.vfat": "dosfstools", "mkfs.exfat": "exfatprogs", "mcopy": "mtools", "mmd": "mtools", "mtype": "mtools",
    "zstd": "zstd", "xz": "xz-utils", "cpio": "cpio", "curl": "curl", "lz4": "lz4", "flex": "flex", "bison": "bison", "bc": "bc",
    "objcopy": "binutils", "objdump": "binutils", "readelf": "binutils", "addr2line": "binutils", "strip": "binutils", "nm": "binutils", "as": "binutils",
    "ar": "binutils", "c++filt": "binutils", "meson": "meson", "dpkg-source": "dpkg-dev",
    "openssl": "openssl", "sbsign": "sbsigntool", "cert-to-efi-sig-list": "efitools", "sign-efi-sig-list": "efitools",
    **{f"aarch64-linux-gnu-{tool}": "binutils-aarch64-linux-gnu" for tool in ("addr2line", "nm", "objcopy", "objdump", "readelf", "strip")},
    "aarch64-linux-gnu-gcc": "gcc-aarch64-linux-gnu",
    "qemu-system-x86_64": "qemu-system-x86", "qemu-system-aarch64": "qemu-system-arm", "qemu-system-arm": "qemu-system-arm", "qemu-aarch64-static": "qemu-user-static", "Xvfb": "xvfb",
    "evtest": "evtest", "v4l2-ctl": "v4l-utils", "v4l2-compliance": "v4l-utils", "gpiodetect": "gpiod", "gpioinfo": "gpiod",
    "arecord": "alsa-utils", "aplay": "alsa-utils", "amixer": "alsa-utils", "lsusb": "usbutils",
}
NOT_THERE = {"no-such-program", "no-such-program-of-ours"}  # What a test starts to see how that fails.
ALWAYS = {ESSENTIAL, "systemd", "git"}  # git: without it there is no repository to run in.
# The control: each tool here is of the name "frob-" and a number.
CPP_CONTROL = r"""
const auto ran = RunToEnd({"frob-1", file}, log);
std::vector<std::string> words{"frob-2",     "--silent",
                               answer};
const auto asked = RunToEnd(words, log);
const bool is_there = std::system("frob-3 -o /dev/null " PROGRAM " --help") == 0;
EXPECT_EQ(std::system(("frob-4 -o " + trace + " " PROGRAM).c_str()), 0);
int Explain(const std::string& report) {
  const auto command = fmt::format("frob-5 {}", report);
  return std::system(command.c_str());
}
std::string Among(const std::string& command) {
  return "frob-6 " + user + "--mount sh -c 'frob-7 x && " + command + "'";
}
int Ran(const std::string& command) {
  return ::pclose(::popen((command + " 2>&1").c_str(), "r"));
}
EXPECT_EQ(Ran(Among("frob-8 x; frob-9 y")), 0);
const auto mended = RunToEnd({"sh", "-c", fmt::format("frob-10 '{}' || [ $? -eq 1 ]", file_)}, log);
// RunToEnd({"no-frob"}) and std::system("no-frob") are of comments.
int Run(const std::string& words) {
  return std::system((PROGRAM " " + words).c_str());
}
EXPECT_EQ(Run("no-frob 1-2"), 2);
"""
BUILTINS = set("[ [[ ]] : . source exit return local declare readonly export set shift trap eval exec cd echo read mapfile unset "
               "command type compgen wait times let pushd popd builtin getopts ulimit umask printf kill test true false "
               "break continue if then else elif fi for while until do done case esac in function select time { } ! coproc".split())
# What runs on the box, whose image has tools of its own, or in another builder.
ELSEWHERE = ("rootfs/overlay/", "rootfs/yocto/")
# Language -> the endings of its files, and how the first line of a file without an ending begins.
LANGUAGES = {
    "shell": ((".sh",), r"#!.*\b(ba|da)?sh\b"),
    "python": ((".py",), r"#!.*\bpython"),
    "cpp": ((".cpp",), r"(?!)"),
    "node": ((".mjs", ".js"), r"#!.*\bnode\b"),
}
CPP_ROOMS = ("hw-sim/", "tests/", "appliance/authoring/")  # The box's own programs start what is on the box.
PREFIXES = ("exec", "nice", "time", "command", "!", "if", "while", "until", "then", "else", "elif", "do", "env", "timeout", "sudo")


def without_texts(script):
    """The script without here-documents, comments, quoted texts, arrays and what `case` matches."""
    script = re.sub(r"<<-?\s*'?(\w+)'?[^\n]*\n.*?\n\s*\1\n", "\n", script, flags=re.DOTALL)
    script = re.sub(r"\\\n", " ", script)
    script = re.sub(r"(?m)(^|\s)#[^\n]*", r"\1", script)
    # Of quoted text only the commands in it are left.
    script = re.sub(r"""'[^']*'|"((?:[^"\\]|\\.)*)\"""",
                    lambda text: '""' + " ".join(re.findall(r"\$\([^()]*\)", text[1] or "")), script)
    script = re.sub(r"\[\[.*?\]\]|\$\(\([^)]*\)\)|\$\{[^{}]*\}", "true", script)
    script = re.sub(r"(?m)^\s*[^\s()]*(?:\s*\|\s*[^\s()]*)*\)", "", script)  # Patterns of `case`.
    return re.sub(r"(?m)^[^\n()]*=\((?:[^()]|\([^()]*\))*\)", "true", script)


def shell_tools(script):
    """Names in command position that are neither builtins nor functions of the script."""
    script = without_texts(script)
    functions = set(re.findall(r"(?m)^\s*([\w-]+)\(\)", script))
    found = set()
    for piece in re.split(r"\$\(|<\(|\|\||&&|[;|&\n({]", script):
        words = piece.strip().split()
        while words and (words[0] in PREFIXES or re.match(r"\w+\+?=", words[0])):
            words.pop(0)
        if words and re.fullmatch(r"[a-z][\w.+-]*", words[0]) and words[0] not in BUILTINS | functions:
            found.add(words[0].rstrip(")"))
    return found, functions


def python_tools(source):
    """The first word of each literal command that subprocess or a function named run gets."""
    found = set()
    for call in ast.walk(ast.parse(source)):
        if not isinstance(call, ast.Call) or not call.args:
            continue
        name = call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", "")
        if name == "tool":  # Of rootfs/image/architectures.py: this machine's, and the cross compiler's.
            found.update((call.args[0].value, f"aarch64-linux-gnu-{call.args[0].value}"))
        if name not in ("run", "Popen", "check_output", "check_call"):
            continue
        first = call.args[0]
        if isinstance(first, (ast.List, ast.Tuple)) and first.elts:
            first = first.elts[0]
        if isinstance(first, ast.Constant) and isinstance(first.value, str):
            found.add(first.value)
    return found


def node_tools(source):
    return set(re.findall(r"\b(?:execFile|execFileSync|spawn|spawnSync)\(\s*'([^']+)'", source))


def carried_tools(script):
    """What tests/hil/bench_disk lays on the agent's disk: TOOLS=(...)."""
    return {tool for listed in re.findall(r"\bTOOLS=\(([^)]*)\)", script) for tool in listed.split()}


def installed(repository):
    """All packages that one of ./box's lists names."""
    packages = set()
    for script in [repository / "box", *repository.glob("*/*.sh"), *repository.glob("*/*/*.sh")]:
        text = re.sub(r"(?m)#[^\n]*", "", script.read_text())
        for listed in re.findall(r"\w*PACKAGES=\(([^)]*)\)", text):
            packages.update(listed.split())
        for listed in re.findall(r"(?m)\bneed ([a-z][^\n;&|]*)", text):
            packages.update(listed.split())
    return packages


def tracked(repository, language):
    """The files of a language, by their ending or their first line."""
    endings, first_line = LANGUAGES[language]
    listed = subprocess.run(["git", "-C", repository, "ls-files"], capture_output=True, text=True, check=True).stdout
    for name in listed.split():
        path = repository / name
        if name.startswith(ELSEWHERE) or path.is_symlink() or not path.is_file():
            continue
        if path.suffix in endings or (not path.suffix and re.match(first_line, path.read_bytes()[:64].decode("utf-8", "replace"))):
            yield path


def calls(repository):
    """(file, tool) for all that is called."""
    scripts = {path: shell_tools(path.read_text()) for path in tracked(repository, "shell")}
    shared = set().union(*(functions for _, functions in scripts.values()))  # ./box reads the others' functions.
    for path, (found, _) in scripts.items():
        yield from ((path, tool) for tool in sorted((found - shared) | carried_tools(path.read_text())))
    for path in tracked(repository, "python"):
        yield from ((path, tool) for tool in sorted(python_tools(path.read_text())))
    for path in tracked(repository, "cpp"):
        if str(path.relative_to(repository)).startswith(CPP_ROOMS):
            yield from ((path, tool) for tool in sorted(cpp_tools(path.read_text(), shell_tools)))
    for path in tracked(repository, "node"):
        yield from ((path, tool) for tool in sorted(node_tools(path.read_text())))


def faults(found, packages):
    for path, tool in found:
        if tool in NOT_THERE:
            continue
        package = TOOLS.get(tool)
        if package is None:
            yield f"{path}: {tool}: no package is known for it; name it in tools_test.py"
        elif package not in packages | ALWAYS:
            yield f"{path}: {tool}: no list of ./box has its package, {package}"


def main():
    repository = Path(sys.argv[1])
    packages = installed(repository)
    found = list(calls(repository))
    wrong = list(faults(found, packages))
    read = {path.suffix for path, _ in found}
    if not {"", ".sh", ".py", ".cpp", ".mjs"} <= read:
        wrong.append(f"the control: of {sorted(read)} something is not read any more")
    missing = list(faults([(Path("control"), tool) for tool in shell_tools("ls | cpio -o\nfrobnicate x\n")[0]],
                          packages - {"cpio"}))
    if len(missing) != 2:
        wrong.append(f"the control: {missing}: a tool without a package, and one that nobody knows, are not both found")
    in_cpp = cpp_tools(CPP_CONTROL, shell_tools) - {"sh"}
    if in_cpp != {f"frob-{number}" for number in range(1, 11)}:
        wrong.append(f"the control: {sorted(in_cpp)} were seen of the ten tools in C++")
    print(f"{len({tool for _, tool in found})} tools in {len({path for path, _ in found})} files")
    if wrong:
        sys.exit("\n".join(wrong))


main()
