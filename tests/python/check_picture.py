"""Runs a script of the gallery, which must write one picture that shows something.

usage: check_picture.py SCRIPT OUTPUT_FOLDER
"""

import importlib.util
import pathlib
import subprocess
import sys

script, output = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
if importlib.util.find_spec("matplotlib") is None:
    print("skipped: no matplotlib")
    sys.exit(77)
picture = output / (script.stem + ".png")
picture.unlink(missing_ok=True)
subprocess.run([sys.executable, script, output], check=True)
from matplotlib import image  # noqa: E402: only where there is one

pixels = image.imread(picture)
height, width = pixels.shape[:2]
assert width >= 600 and height >= 300, (width, height)
# Neither blank nor one flat colour.
assert pixels[..., :3].std() > 0.05, pixels.std()
