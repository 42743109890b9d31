"""Builds the wheel, installs it into a fresh environment without an index, and imports it there.

usage: check_wheel.py CMAKE BUILD_FOLDER IGNORED WORK_FOLDER
"""

import importlib.util
import pathlib
import shutil
import subprocess
import sys

PROGRAM = """
import importlib.metadata, libhair, pathlib, sys
assert pathlib.Path(libhair.__file__).is_relative_to(sys.prefix), libhair.__file__
assert importlib.metadata.version("libhair") == libhair.__version__
simulation = libhair.Simulation(libhair.make_groom(libhair.style_settings().replace(strands=30, wisps=5)))
simulation.run(2)
print(simulation, simulation.state_hash())
"""

cmake, build, _, work = sys.argv[1:]
work = pathlib.Path(work)
if importlib.util.find_spec("ensurepip") is None:
    print("skipped: no python3-venv")
    sys.exit(77)
shutil.rmtree(work, ignore_errors=True)
subprocess.run([cmake, "--build", build, "--target", "wheel"], check=True)
wheel, = (pathlib.Path(build) / "python" / "dist").glob("*.whl")
# NumPy is the system's.
subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", work / "venv"], check=True)
python = work / "venv" / "bin" / "python"
subprocess.run([python, "-m", "pip", "install", "--no-index", "--no-deps", wheel], check=True)
subprocess.run([python, "-c", PROGRAM], check=True, cwd=work, env={})
subprocess.run([python, "-m", "pip", "uninstall", "-y", "libhair"], check=True)
