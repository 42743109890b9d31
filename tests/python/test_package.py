"""What the package says of itself: docstrings, stubs, and no other symbols."""

import importlib.util
import inspect
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

import libhair
from libhair import _libhair

SOURCE = pathlib.Path(os.environ["HAIR_SOURCE_DIR"]) / "python"
QUIET = {"__module__", "__doc__", "__hash__", "__init__", "__repr__", "__eq__", "_fields",
         "__getstate__", "__setstate__"}


def own_doc(value):
    """A docstring without the signatures that pybind11 puts before it."""
    lines = (inspect.getdoc(value) or "").splitlines()
    return " ".join(l for l in lines if "->" not in l and l != "Overloaded function.").strip()


def members():
    for name in libhair.__all__:
        value = getattr(libhair, name)
        yield name, value
        if isinstance(value, type):
            for member, inner in vars(value).items():
                if member not in QUIET:
                    yield f"{name}.{member}", getattr(inner, "__func__", inner)


class Docs(unittest.TestCase):
    def test_every_public_name_has_a_docstring(self):
        names = list(members())
        self.assertGreater(len(names), 250)
        missing = [n for n, v in names if callable(v) or isinstance(v, (type, property)) if not own_doc(v)]
        self.assertEqual(missing, [])

    def test_arrays_have_their_shapes_in_the_docs(self):
        for name in ("Strands", "Strands.points", "Simulation.points", "Simulation.colours",
                     "Simulation.radiance", "shade", "encode_srgb", "shadow",
                     "Groom.guide_points", "DensityMap.density_grid", "Truth.transmittance"):
            doc = own_doc(dict(members())[name])
            self.assertRegex(doc, r"\(.*\bN\b.*\)|\(S|\(G|\(I|\(N,\)", name)

    def test_everything_has_a_repr(self):
        classes = [v for _, v in members() if isinstance(v, type) and v is not libhair.Error]
        missing = [c.__name__ for c in classes if "__repr__" not in vars(c)]
        self.assertEqual(missing, [])


class Stubs(unittest.TestCase):
    def test_the_stubs_are_what_is_written_of_the_extension(self):
        said = subprocess.run([sys.executable, SOURCE / "write_stubs.py", "--check"],
                              capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stderr)

    def test_mypy_finds_the_stubs_true(self):
        if importlib.util.find_spec("mypy") is None:
            self.skipTest("no mypy")
        folder = pathlib.Path(_libhair.__file__).parent.parent
        said = subprocess.run(
            [sys.executable, "-m", "mypy.stubtest", "libhair"], capture_output=True, text=True,
            env={**os.environ, "MYPYPATH": str(folder), "PYTHONPATH": str(folder)})
        # Names of types are for stubs alone; pybind11's classes have a metaclass of its own, and a
        # constructor that refuses where they have none.
        quiet = ("metaclass differs", '__init__ is inconsistent, stub does not have *args argument "args"')
        quiet += tuple(f"{n} is not present at runtime" for n in (
            "_Numbers", "_Place", "Vec3", "IVec3", "Quaternion", *_libhair._choices))
        errors = [l for l in said.stdout.splitlines() if l.startswith("error")]
        self.assertEqual([l for l in errors if not l.endswith(quiet)], [])
        self.assertIn("checked 2 modules", said.stdout)

    def test_mypy_passes_the_gallery(self):
        if importlib.util.find_spec("mypy") is None:
            self.skipTest("no mypy")
        folder = pathlib.Path(_libhair.__file__).parent.parent
        scripts = sorted((SOURCE / "gallery").glob("*.py"))
        self.assertGreater(len(scripts), 4)
        for script in scripts:
            said = subprocess.run(
                [sys.executable, "-m", "mypy", "--ignore-missing-imports", "--cache-dir=/dev/null",
                 "--follow-imports=silent", script],
                capture_output=True, text=True, env={**os.environ, "MYPYPATH": str(folder)})
            self.assertEqual(said.returncode, 0, said.stdout + said.stderr)


class Symbols(unittest.TestCase):
    def test_one_symbol_is_for_others(self):
        nm = shutil.which("nm")
        if nm is None:
            self.skipTest("no nm")
        said = subprocess.run([nm, "-D", "--defined-only", _libhair.__file__],
                              capture_output=True, text=True, check=True)
        self.assertEqual([l.split()[-1] for l in said.stdout.splitlines()], ["PyInit__libhair"])


if __name__ == "__main__":
    unittest.main()
