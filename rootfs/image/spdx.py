"""What is in an image as an SPDX 2.3 document."""

import hashlib
import re
import uuid
from datetime import datetime, timezone
from typing import NamedTuple

ROOT = "SPDXRef-image"
NONE = "NOASSERTION"


class Image(NamedTuple):
    """Its root's hash, the project's version, and the date that everything in it bears (seconds since 1970)."""

    root_hash: str
    version: str
    made_s: int


def date(image):
    return datetime.fromtimestamp(image.made_s, timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")


def unique(image, kind):
    """An id of a document of this image: the same for the same root."""
    return uuid.uuid5(uuid.NAMESPACE_URL, f"kaori-box/{kind}/{image.root_hash}")


def reference(part):
    return "SPDXRef-part-" + re.sub(r"[^A-Za-z0-9.]+", "-", part.name)


def verification_code(files):
    """Of a package's files, as section 7.9 of the specification has it."""
    return hashlib.sha1("".join(sorted(file.sha1 for file in files)).encode()).hexdigest()


def purl(package):
    """Debian's package as a package URL."""
    source = "" if package.source == package.name and package.source_version == package.version else \
        f"&upstream={quoted(package.source)}%40{quoted(package.source_version)}"
    return f"pkg:deb/debian/{quoted(package.name)}@{quoted(package.version)}?arch={package.architecture}&distro=bookworm{source}"


def quoted(text):
    return text.replace("%", "%25").replace("+", "%2B").replace(":", "%3A")


def of_part(part):
    package = {"SPDXID": reference(part), "name": part.name, "versionInfo": part.version, "supplier": part.supplier,
               "downloadLocation": NONE, "filesAnalyzed": bool(part.files), "licenseConcluded": NONE,
               "licenseDeclared": part.licence, "copyrightText": NONE, "summary": part.what}
    if part.files:
        package["packageVerificationCode"] = {"packageVerificationCodeValue": verification_code(part.files)}
    if part.package:
        package["sourceInfo"] = f"built of Debian's source {part.package.source} {part.package.source_version}"
        package["externalRefs"] = [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                                    "referenceLocator": purl(part.package)}]
    return package


def of_file(number, file):
    return {"SPDXID": f"SPDXRef-file-{number}", "fileName": f"./{file.path}", "licenseConcluded": NONE,
            "copyrightText": NONE, "checksums": [{"algorithm": "SHA1", "checksumValue": file.sha1},
                                                 {"algorithm": "SHA256", "checksumValue": file.sha256}]}


def relation(one, kind, other):
    return {"spdxElementId": one, "relationshipType": kind, "relatedSpdxElement": other}


def document(image, parts, texts):
    """`texts`: {licence reference: its text}."""
    files, relations = [], [relation("SPDXRef-DOCUMENT", "DESCRIBES", ROOT)]
    for part in parts:
        relations.append(relation(ROOT, "CONTAINS", reference(part)))
        for file in part.files:
            files.append(of_file(len(files), file))
            relations.append(relation(reference(part), "CONTAINS", files[-1]["SPDXID"]))
    whole = {"SPDXID": ROOT, "name": "kaori-box-image", "versionInfo": image.version, "downloadLocation": NONE,
             "filesAnalyzed": False, "licenseConcluded": NONE, "licenseDeclared": NONE, "copyrightText": NONE,
             "summary": f"image of the Kaori box whose verified root has the hash {image.root_hash}",
             "primaryPackagePurpose": "OPERATING-SYSTEM"}
    return {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": "kaori-box-image",
            "documentNamespace": f"urn:uuid:{unique(image, 'spdx')}",
            "creationInfo": {"created": date(image), "creators": ["Tool: kaori-sbom"]},
            "packages": [whole, *map(of_part, parts)], "files": files, "relationships": relations,
            "hasExtractedLicensingInfos": [{"licenseId": name, "extractedText": text or NONE} for name, text in sorted(texts.items())]}
