"""What is in an image as a CycloneDX 1.5 document."""

import spdx

IMAGE = "kaori-box-image"


def of_file(file):
    return {"type": "file", "name": file.path, "hashes": [{"alg": "SHA-1", "content": file.sha1},
                                                          {"alg": "SHA-256", "content": file.sha256}]}


def of_part(part):
    """A component, and in it one for each of its files."""
    component = {"type": "library" if part.package else "application", "bom-ref": part.name, "name": part.name,
                 "version": part.version, "description": part.what}
    if part.licence != spdx.NONE:
        component["licenses"] = [{"expression": part.licence}]
    if part.package:
        component["supplier"] = {"name": "Debian"}
        component["purl"] = spdx.purl(part.package)
        component["properties"] = [{"name": "debian:source", "value": f"{part.package.source} {part.package.source_version}"}]
    if part.files:
        component["components"] = [of_file(file) for file in part.files]
    return component


def document(image, parts):
    whole = {"type": "operating-system", "bom-ref": IMAGE, "name": IMAGE, "version": image.version,
             "description": f"image of the Kaori box whose verified root has the hash {image.root_hash}"}
    return {"bomFormat": "CycloneDX", "specVersion": "1.5", "serialNumber": f"urn:uuid:{spdx.unique(image, 'cyclonedx')}",
            "version": 1,
            "metadata": {"timestamp": spdx.date(image), "component": whole,
                         "tools": {"components": [{"type": "application", "name": "kaori-sbom", "version": image.version}]}},
            "components": [of_part(part) for part in parts],
            "dependencies": [{"ref": IMAGE, "dependsOn": [part.name for part in parts]}]}
