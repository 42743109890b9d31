"""Installs the component python into a prefix and imports it from there alone.

usage: check_installed.py CMAKE BUILD_FOLDER PACKAGE_FOLDER_BELOW_PREFIX WORK_FOLDER
"""

import pathlib
import shutil
import subprocess
import sys

PROGRAM = """
import sys; sys.path.insert(0, sys.argv[1])
import libhair, numpy
assert libhair.__file__.startswith(sys.argv[1]), libhair.__file__
hair = libhair.Strands(numpy.linspace(0, 0.1, 30, dtype=numpy.float32).reshape(2, 5, 3))
print(libhair.__version__, libhair.shadow(hair, libhair.Light.parallel((0, -1, 0))).shape)
"""

cmake, build, below, work = sys.argv[1:]
work = pathlib.Path(work)
shutil.rmtree(work, ignore_errors=True)
subprocess.run([cmake, "--install", build, "--component", "python", "--prefix", work], check=True,
               stdout=subprocess.DEVNULL)
folder = work / below
names = sorted(p.name for p in (folder / "libhair").iterdir())
assert [n for n in names if not n.endswith(".so")] == ["__init__.py", "__init__.pyi", "_libhair.pyi", "py.typed"], names
subprocess.run([sys.executable, "-c", PROGRAM, folder], check=True, cwd=work, env={})
