#!/usr/bin/env python3
"""Whether a picture of the docs that is older than what it shows is noticed; docs/pictures.py check names those that are."""

import pathlib
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs"))
import pictures  # noqa: E402


def notices_a_change():
    """A picture is new with the checksum of its sources, and old when a file of them changes, comes or goes."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "page").mkdir()
        (root / "page/a.js").write_text("one")
        (root / "a.png").write_bytes(b"picture")
        shown = {"a.png": ("page",)}

        def is_old(sums):
            return bool(pictures.old_pictures(shown, sums, root))

        sums = {"a.png": pictures.checksum(("page",), root)}
        assert not is_old(sums), "a picture that was just made is old"
        assert is_old({}), "a picture without a checksum is not old"
        (root / "page/b.js").write_text("")
        assert is_old(sums), "a new file of the page was not noticed"
        (root / "page/b.js").unlink()
        assert not is_old(sums)
        (root / "page/a.js").write_text("two")
        assert is_old(sums), "a changed file of the page was not noticed"
        (root / "page/a.js").write_text("one")
        (root / "a.png").unlink()
        assert is_old(sums), "a picture that is gone was not noticed"


def notices_changed_drawing_and_no_comment():
    """Of code only what is compiled counts."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "passes").mkdir()
        file = root / "passes/hair.frag"

        def of(text):
            file.write_text(text)
            return pictures.checksum(("passes",), root)

        drawn = of("// A lock.\nfloat shine = 0.5;\n")
        assert of("/* Of hair,\n wet. */ float  shine = 0.5;  // As\n") == drawn, "a comment makes a picture old"
        assert of("// A lock.\nfloat shine = 0.6;\n") != drawn, "changed drawing was not noticed"
        (root / "passes/CMakeLists.txt").write_text("one")
        listed = of("// A lock.\nfloat shine = 0.5;\n")
        (root / "passes/CMakeLists.txt").write_text("two")
        assert of("// A lock.\nfloat shine = 0.5;\n") == listed, "a list of what is built makes a picture old"


def pictures_with_a_face_show_how_it_is_drawn():
    for name, sources in pictures.PICTURES.items():
        assert name == "docs/desk.png" or {"render/shaders", "appliance/authoring/sculpt"} <= set(sources), name


def no_picture_is_left_out():
    """A raster picture of a page that PICTURES does not name would never be called old."""
    there = {str(file.relative_to(ROOT)) for file in (ROOT / "docs").rglob("*") if file.suffix in (".png", ".jpg", ".jpeg", ".gif", ".webp")}
    assert there == set(pictures.PICTURES), f"docs/pictures.py does not make {there - set(pictures.PICTURES)}"


def pictures_of_pages_show_what_takes_them():
    for name in ("docs/console.png", "docs/desk.png"):
        assert "docs/pictures.mjs" in pictures.PICTURES[name], name


def every_source_exists():
    for name, sources in pictures.PICTURES.items():
        for source in sources:
            assert (ROOT / source).exists(), f"{name} is said to show {source}, which is not there"
    made = {name for names, _ in pictures.MAKERS for name in names}
    assert made == set(pictures.PICTURES), f"nothing makes {set(pictures.PICTURES) - made}"


if __name__ == "__main__":
    notices_a_change()
    notices_changed_drawing_and_no_comment()
    pictures_with_a_face_show_how_it_is_drawn()
    no_picture_is_left_out()
    pictures_of_pages_show_what_takes_them()
    every_source_exists()
