#!/usr/bin/env python3
"""Whether the layer for OpenEmbedded agrees with what is built, and whether faults of each kind are found:
layer_test.py ROOT BUILD"""

import shutil
import sys
import tempfile
import unittest
from pathlib import Path

ROOT, BUILD = (Path(word).resolve() for word in sys.argv[1:3])
sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parent))
import layer  # noqa: E402

# (file, what stands there, what is put in its place, what is then said).
SEEDED = (
    (layer.RECIPE, "-DKAORI_SIMULATOR=OFF", "-DKAORI_SIMULATION=OFF", "cmake knows no option KAORI_SIMULATION"),
    (layer.RECIPE, "alsa-lib", "alsa-library", "nobody is known to have alsa-library"),
    (layer.RECIPE, ",libcamera\"", ",libcamara\"", "nobody is known to have libcamara"),
    (layer.RECIPE, "${systemd_system_unitdir} ${nonarch_base", "${nonarch_base", "no package has /usr/lib/systemd/system/kaori.target"),
    (layer.RECIPE, "${bindir}/kaori-desk", "${bindir}/kaori-disk", "nothing that is installed is /usr/bin/kaori-disk"),
    (layer.RECIPE, "\"kaori.target\"", "\"kaori-face.target\"", "kaori-face.target is not installed"),
    (layer.RECIPE, "--user-group kaori-lips", "--user-group kaori-lip", "kaori-lips.service runs as kaori-lips, whom nobody makes"),
    (layer.RECIPE, "LICENSE;md5=3b", "LICENSE;md5=4b", "LICENSE has changed"),
    (layer.LAYER / "wic/kaori-box.wks", "--fixed-size 384M", "--fixed-size 385M", "its partitions are not those"),
    (layer.KAS / "qemuarm64.yml", "- kaori-box.yml", "- kaori-bax.yml", "there is no kaori-bax.yml"),
    (layer.KAS / "kaori-box.yml", "target: kaori-box-image", "target: kaori-image", "there is no image kaori-image"),
    (Path("rootfs/overlay/usr/lib/systemd/system/kaori.target"), "[Install]", "[Unit]", "has no [Install]"),
)


class TheLayer(unittest.TestCase):
    def test_has_no_fault(self):
        self.assertEqual(list(layer.offences(ROOT, BUILD)), [])

    def test_every_seeded_fault_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder)
            shutil.copytree(ROOT / "rootfs", copy / "rootfs", symlinks=True)
            shutil.copy(ROOT / "LICENSE", copy)
            for path, right, wrong, said in SEEDED:
                with self.subTest(said):
                    text = (ROOT / path).read_text()
                    self.assertIn(right, text)
                    (copy / path).write_text(text.replace(right, wrong))
                    found = list(layer.offences(copy, BUILD))
                    self.assertTrue(any(said in line for line in found), found)
                    (copy / path).write_text(text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
