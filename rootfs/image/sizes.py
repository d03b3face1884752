"""Which part of an image weighs what: the files of its root by what they are for."""

# (part, beginnings of paths below the root); a file belongs to the first that fits, and else to "system".
KINDS = (
    ("show", ("usr/share/kaori/kaori.kaori", "usr/share/kaori/still.ppm")),
    ("programs", ("usr/bin/kaori-",)),
    ("mesa", ("usr/lib/*/dri/", "usr/lib/*/libEGL_mesa", "usr/lib/*/libgbm", "usr/lib/*/libglapi")),
    ("llvm", ("usr/lib/*/libLLVM",)),
    ("desk", ("usr/lib/*/libgnutls", "usr/lib/*/libunistring", "usr/lib/*/libp11-kit", "usr/lib/*/libgmp", "usr/lib/*/libnettle",
              "usr/lib/*/libhogweed", "usr/lib/*/libidn2", "usr/lib/*/libtasn1", "usr/lib/*/libmicrohttpd")),
    ("systemd", ("usr/lib/*/systemd/", "usr/lib/systemd/", "usr/bin/systemctl", "usr/bin/udevadm", "usr/bin/journalctl")),
    ("time zones", ("usr/share/zoneinfo/",)),
)


def fits(path, beginning):
    """Whether a path begins so; a * stands for one folder, the processor's."""
    words, wanted = path.split("/"), beginning.split("/")
    return len(words) >= len(wanted) and words[len(wanted) - 1].startswith(wanted[-1]) and \
        all(pattern in ("*", word) for word, pattern in zip(words, wanted[:-1]))


def part_of(path):
    return next((name for name, beginnings in KINDS if any(fits(path, beginning) for beginning in beginnings)), "system")


def parts(root, others):
    """{part: its files}, each file once whatever its names, and what lies beside the root."""
    found, seen = dict(others), set()
    for path in sorted(root.rglob("*")):
        if path.is_symlink() or not path.is_file() or path.stat().st_ino in seen:
            continue
        seen.add(path.stat().st_ino)
        found.setdefault(part_of(str(path.relative_to(root))), []).append(path)
    return found
