#!/usr/bin/env python3
"""Whether the layer for OpenEmbedded agrees with what is built, and whether faults of each kind are found:
layer_test.py ROOT BUILD [--grammar NODE_MODULES]

With --grammar what layer.py finds by bitbake's grammar and by kas's schema too; without, the schema alone where this machine has
it, and what was not tried is skipped by name."""

import importlib.util
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

ROOT, BUILD = (Path(word).resolve() for word in sys.argv[1:3])
MODULES = Path(sys.argv[4]).resolve() if sys.argv[3:4] == ["--grammar"] else None
sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parent))
import layer  # noqa: E402

OF_IMAGE = layer.layer_system.IMAGE
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
    (Path("rootfs/install.cmake"), "${overlay}/systemd/system/mend-data.service", "${overlay}/systemd/system/default.target",
     "/usr/lib/systemd/system/default.target is a file of the package systemd"),
    (Path("rootfs/install.cmake"), "${overlay}/systemd/system/kaori-.service.d", "${overlay}/systemd/system/sysinit.target.wants",
     "/usr/lib/systemd/system/sysinit.target.wants/systemd-udevd.service is a file of the package systemd"),
    (OF_IMAGE, "\"kaori.target\"", "\"kaori.service\"", "the system starts kaori.service, which is no target of the box"),
    (OF_IMAGE, "SYSTEMD_DEFAULT_TARGET", "DEFAULT_TARGET", "the system starts multi-user.target, which is no target"),
    (Path("rootfs/overlay/usr/lib/systemd/system/kaori.target"), "Requires=basic.target", "Requires=multi-user.target", "wants what wants a getty"),
    (layer.KAS / "kaori-box.yml", "/var/volatile/cache /var/cache", "/var/volatile/lib /var/lib", "lays memory over /var/lib, and so over /var/lib/kaori"),
    (layer.KAS / "kaori-box.yml", "VOLATILE_BINDS", "VOLATILES", "VOLATILE_BINDS is not set"),
    (layer.KAS / "qemuarm64.yml", "init=/usr/bin/kaori-boot", "init=/sbin/init", "qemuarm64.yml: the kernel is not told init=/usr/bin/kaori-boot"),
    (layer.KAS / "qemuarm64.yml", "/dev/vda2 ro", "/dev/vda ro", "QB_KERNEL_ROOT is not /dev/vda2 ro"),
    (layer.KAS / "qemuarm64.yml", "QB_DEFAULT_FSTYPE = \"wic\"", "QB_DEFAULT_FSTYPE = \"ext4\"", "QB_DEFAULT_FSTYPE is not wic"),
    (layer.KAS / "raspberrypi4-64.yml", " usbcore.authorized_default=0", "", "raspberrypi4-64.yml: the kernel is not told usbcore.authorized_default=0"),
    (layer.LAYER / "recipes-support/qhull/qhull_2020.2.bb", ";striplevel=1", "", "its archive is not unpacked where S points to"),
    (layer.LAYER / "wic/kaori-box-raspberrypi.wks", "--fixed-size 384M", "--fixed-size 385M", "kaori-box-raspberrypi.wks: its partitions are not those"),
    (layer.LAYER / "conf/layer.conf", "\"scarthgap\"", "\"scarthgap wrynose\"", "it claims scarthgap wrynose, and scarthgap is fetched"),
    (layer.RECIPE, "harfbuzz-native", "alsa-lib-native", "nobody is known to have alsa-lib-native"),
    (layer.RECIPE, "fmt freetype glm", "fmt freetype gnutls", "nobody is known to have gnutls-native"),
    (layer.RECIPE, "e2fsprogs-mke2fs", "e2fsprogs-mkfs", "nobody is known to have e2fsprogs-mkfs"),
    (layer.LAYER / "recipes-support/qhull/qhull_2020.2.bb", "BBCLASSEXTEND = \"native\"", "", "nobody is known to have qhull-native"),
)
# The same, of what only the grammar of recipes finds, and of what only kas's schema does.
OF_GRAMMAR = (
    (layer.RECIPE, "inherit cmake", "inherit = cmake", "kaori-box_git.bb:19: not what bitbake's grammar expects"),
    (layer.RECIPE, 'PV = "0.2+git"', 'PV = "0.2+git', "not what bitbake's grammar expects"),
    (layer.LAYER / "conf/layer.conf", 'BBPATH .= ":${LAYERDIR}"', 'BBPATH .=', "layer.conf:3: not what bitbake's grammar expects"),
)
OF_SCHEMA = (
    (layer.KAS / "qemuarm64.yml", "version: 11", "version: eleven", "qemuarm64.yml: 'eleven' is not"),
    (layer.KAS / "genericx86-64.yml", "machine: genericx86-64", "machines: genericx86-64", "'machines' was unexpected"),
    (layer.KAS / "kaori-box.yml", "distro: poky", "distro: [poky]", "kaori-box.yml: ['poky'] is not of type"),
)
HAS_SCHEMA = layer.KAS_SCHEMA.is_file() and all(importlib.util.find_spec(name) for name in ("jsonschema", "yaml"))


class TheLayer(unittest.TestCase):
    def test_has_no_fault(self):
        self.assertEqual(list(layer.offences(ROOT, BUILD, MODULES)), [])

    @unittest.skipUnless(HAS_SCHEMA, "kas is not installed: ./box test --arm64 brings it")
    def test_every_fault_that_the_schema_of_kas_finds_is_found(self):
        self.assertEqual(list(layer.against_schema(ROOT)), [])
        self.find(OF_SCHEMA, layer.against_schema)

    @unittest.skipUnless(MODULES and HAS_SCHEMA, "there is no grammar of recipes: ./box test --arm64 brings it")
    def test_every_fault_that_the_grammar_or_the_schema_finds_is_named_among_all(self):
        self.find(OF_GRAMMAR, lambda copy: layer.grammar(copy, MODULES))
        self.find(OF_GRAMMAR[:1] + OF_SCHEMA[:1], lambda copy: layer.offences(copy, BUILD, MODULES))

    def test_every_seeded_fault_is_found(self):
        self.find(SEEDED, lambda copy: layer.offences(copy, BUILD))

    def find(self, seeded, faults):
        """Seeds one fault after the other into a copy, and wants it among the faults of that copy."""
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder)
            shutil.copytree(ROOT / "rootfs", copy / "rootfs", symlinks=True)
            shutil.copy(ROOT / "LICENSE", copy)
            for path, right, wrong, said in seeded:
                with self.subTest(said):
                    text = (ROOT / path).read_text()
                    self.assertIn(right, text)
                    (copy / path).write_text(text.replace(right, wrong))
                    found = list(faults(copy))
                    self.assertTrue(any(said in line for line in found), found)
                    (copy / path).write_text(text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
