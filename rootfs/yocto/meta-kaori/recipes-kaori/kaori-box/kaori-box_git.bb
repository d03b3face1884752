SUMMARY = "A show box whose face is played by four operators"
DESCRIPTION = "Reads dials, joysticks, a keyboard, GPIO lines, a camera that watches painted lips and a microphone, and \
draws a living face with GLES 3 on every screen."
SECTION = "multimedia"
LICENSE = "Apache-2.0 & BitstreamVera"
LIC_FILES_CHKSUM = "file://LICENSE;md5=3b83ef96387f14655fc854ddc3c6bd57 \
                    file://dejavu-fonts-ttf-2.37/LICENSE;md5=449b2c30bfe5fa897fe87b8b70b16cfa"
# The Japanese letters, Motoya L Cedar, are under the Apache-2.0 too; their archive holds the font alone.

# Source and fonts are unpacked where S points to by itself, in releases that know UNPACKDIR and in those before.
SRC_URI = "git://${KAORI_REPOSITORY};protocol=file;branch=${KAORI_BRANCH};destsuffix=${BP} \
           ${SOURCEFORGE_MIRROR}/dejavu/dejavu-fonts-ttf-2.37.tar.bz2;name=font;subdir=${BP} \
           ${DEBIAN_MIRROR}/main/f/fonts-motoya-l-cedar/fonts-motoya-l-cedar_1.01.orig.tar.xz;name=japanese;subdir=${BP}"
SRCREV = "${AUTOREV}"
SRC_URI[font.sha256sum] = "fa9ca4d13871dd122f61258a80d01751d603b4d3ee14095d65453b4e846e17d7"
SRC_URI[japanese.sha256sum] = "39823186e3a10ee36a9647da43394341d77756d3fde65a664c76a40b832efaa8"
PV = "0.2+git"

inherit cmake pkgconfig systemd useradd features_check

REQUIRED_DISTRO_FEATURES:class-target = "systemd opengl"

# What the face is drawn and the show is packed with; harfbuzz-native has hb-subset, which cuts the Japanese font.
DEPENDS = "flatbuffers flatbuffers-native fmt freetype glm harfbuzz-native libjpeg-turbo libpng libsodium tl-expected tomlplusplus \
           virtual/egl virtual/libgles2 zstd"
# What the programs of the box open besides: devices, cards, screens. The show is packed by a kaori-atelier that runs here.
DEPENDS:append:class-target = " alsa-lib kaori-box-native libdrm libgpiod libusb1 udev virtual/libgbm"
# What kaori-atelier reads and models with.
DEPENDS:append:class-native = " nlohmann-json-native qhull-native tinygltf-native tinyobjloader-native"

PACKAGECONFIG ??= ""
PACKAGECONFIG:class-native = ""
PACKAGECONFIG[box] = "-DKAORI_BOX_SYSTEM=ON,-DKAORI_BOX_SYSTEM=OFF,,e2fsprogs-e2fsck e2fsprogs-mke2fs"
PACKAGECONFIG[camera] = "-DKAORI_LIBCAMERA=ON,-DKAORI_LIBCAMERA=OFF,libcamera"
PACKAGECONFIG[desk] = "-DKAORI_DESK=ON,-DKAORI_DESK=OFF,gnutls libmicrohttpd"

EXTRA_OECMAKE = "-DKAORI_FONT=${S}/dejavu-fonts-ttf-2.37/ttf/DejaVuSans.ttf \
    -DKAORI_JAPANESE_FONT=${S}/fonts-motoya-l-cedar_1.01/MTLc3m.ttf -DBUILD_TESTING=OFF -DKAORI_SIMULATOR=OFF"
EXTRA_OECMAKE:append:class-target = " -DKAORI_AUTHORING=OFF -DKAORI_HOST_TOOLS=${STAGING_BINDIR_NATIVE} \
    -DKAORI_UNIT_DIR=${systemd_system_unitdir} -DKAORI_UDEV_DIR=${nonarch_base_libdir}/udev \
    -DKAORI_TMPFILES_DIR=${nonarch_libdir}/tmpfiles.d"
EXTRA_OECMAKE:append:class-native = " -DKAORI_PROGRAMS=OFF"

USERADD_PACKAGES = "${PN}"
GROUPADD_PARAM:${PN} = "--system kaori; --system render"
USERADD_PARAM:${PN} = "--system --no-create-home --shell /sbin/nologin --user-group kaori-stage; \
                       --system --no-create-home --shell /sbin/nologin --user-group kaori-input; \
                       --system --no-create-home --shell /sbin/nologin --user-group kaori-lips; \
                       --system --no-create-home --shell /sbin/nologin --user-group kaori-fdkeeper; \
                       --system --no-create-home --shell /sbin/nologin --user-group kaori-surface; \
                       --system --no-create-home --shell /sbin/nologin --user-group kaori-desk; \
                       --system --no-create-home --shell /sbin/nologin --user-group kaori-trial"

SYSTEMD_SERVICE:${PN} = "kaori.target"

# kaori-boot is the first program of a box that is nothing else (init=/usr/bin/kaori-boot).
PACKAGES =+ "${PN}-boot ${PN}-desk"
FILES:${PN}-boot = "${bindir}/kaori-boot"
FILES:${PN}-desk = "${bindir}/kaori-desk"
FILES:${PN} += "${datadir}/kaori ${systemd_system_unitdir} ${nonarch_base_libdir}/udev/rules.d ${nonarch_libdir}/tmpfiles.d \
                ${bindir}/kaori-camera-libcamera.so"
RRECOMMENDS:${PN} = "alsa-conf"
# Where kaori-boot looks for the time zone that box.toml names.
RRECOMMENDS:${PN}-boot = "tzdata"

BBCLASSEXTEND = "native"
