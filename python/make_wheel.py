"""Makes a wheel of the built package.

usage: make_wheel.py PACKAGE_FOLDER VERSION LICENSE OUTPUT_FOLDER

For the Python that runs this, on this kind of machine. The extension is linked to the system's
oneTBB and OpenMesh, so that the wheel is for machines that have these too; it says so by its
platform tag, which is linux_* and not manylinux.
"""

import base64
import hashlib
import pathlib
import sys
import sysconfig
import zipfile

METADATA = """\
Metadata-Version: 2.1
Name: libhair
Version: {version}
Summary: Hair simulated and shadowed on the CPU
Requires-Python: >=3.9
Requires-Dist: numpy
License-File: LICENSE
"""
WHEEL = """\
Wheel-Version: 1.0
Generator: libhair make_wheel
Root-Is-Purelib: false
Tag: {tag}
"""


def main(package, version, licence, output):
    package, output = pathlib.Path(package), pathlib.Path(output)
    python = "cp" + sysconfig.get_python_version().replace(".", "")
    tag = f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"
    info = f"libhair-{version}.dist-info"
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    names = ("__init__.py", "__init__.pyi", "_libhair.pyi", "py.typed", "_libhair" + suffix)
    files = {f"libhair/{name}": (package / name).read_bytes() for name in names}
    files[f"{info}/METADATA"] = METADATA.format(version=version).encode()
    files[f"{info}/WHEEL"] = WHEEL.format(tag=tag).encode()
    files[f"{info}/LICENSE"] = pathlib.Path(licence).read_bytes()

    record = f"{info}/RECORD"
    rows = []
    for name, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        rows.append(f"{name},sha256={digest},{len(content)}")
    files[record] = "\n".join(rows + [f"{record},,", ""]).encode()

    output.mkdir(parents=True, exist_ok=True)
    wheel = output / f"libhair-{version}-{tag}.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            # A fixed date: the same files make the same wheel.
            entry = zipfile.ZipInfo(name, (2000, 1, 1, 0, 0, 0))
            entry.external_attr = (0o755 if name.endswith(suffix) else 0o644) << 16
            archive.writestr(entry, content, zipfile.ZIP_DEFLATED)
    print(wheel)


if __name__ == "__main__":
    main(*sys.argv[1:])
