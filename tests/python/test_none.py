"""None is refused, or means what it says, wherever it is given: it never ends the process."""

import os
import re
import subprocess
import sys
import tempfile
import unittest

from hair_for_tests import LIGHT, head_field, small_groom, small_simulation, wavy

import libhair


def parts(text):
    """The parts of a list of arguments between commas that no bracket or quote is around."""
    depth, quoted, part = 0, False, ""
    for c in text:
        quoted ^= c == "'"
        depth += 0 if quoted else (c in "([") - (c in ")]")
        if c == "," and depth == 0:
            yield part.strip()
            part = ""
        else:
            part += c
    if part.strip():
        yield part.strip()


def signatures(doc):
    """Of each overload: [(name, type, default or None)]."""
    for line in (doc or "").split("\n"):
        found = re.fullmatch(r"(?:\d+\. )?\w+\((.*)\) -> .*", line)
        if found and not found[1].startswith("*args"):
            yield [re.fullmatch(r"(\w+): (.*?)(?: = (.*))?", p).groups()
                   for p in parts(found[1]) if p != "*" and not p.startswith("*")]


def callables():
    for name, item in sorted(vars(libhair).items()):
        if name.startswith("_") or not callable(item):
            continue
        if not isinstance(item, type):
            yield name, item
            continue
        for member, method in sorted(vars(item).items()):
            if callable(method) and (member == "__init__" or not member.startswith("_")):
                yield f"{name}.{member}", getattr(item, member)


def samples():
    strands = libhair.Strands(wavy(20))
    points = libhair.choose_points(strands, 4)
    truth = libhair.truth(strands, LIGHT, points, rays=8)
    simulation = small_simulation()
    motion = libhair.Motion.still()
    some = [strands, points, truth, simulation, motion, motion.pose(0), LIGHT, head_field(),
            small_groom(), libhair.builtin_head(), libhair.ShadowMethod(libhair.DensityMapSettings()),
            libhair.DensityMap(libhair.DensityMapSettings(), LIGHT), libhair.DensityGrid(),
            libhair.Transform(),
            libhair.GroomDetail(small_groom()),
            libhair.StrandSequenceWriter(os.path.join(tempfile.gettempdir(), "none.####.hair"))]
    some += [c() for c in vars(libhair).values() if isinstance(c, type) and hasattr(c, "_fields")]
    by_type = {type(s).__name__: s for s in some}
    by_type |= {"object": wavy(20).reshape(-1, 3), "float": 0.01, "int": 1, "str": "", "bytes": b"",
                "os.PathLike": "/nowhere/at all", "Vec3": (1, 2, 3), "bool": False}
    return by_type


def try_all():
    known, tried = samples(), 0
    for name, function in callables():
        for signature in signatures(function.__doc__):
            for argument, kind, default in signature:
                if argument == "self" or default == "None":
                    continue
                given = {}
                for other, of, preset in signature:
                    of = re.sub(r"libhair\._libhair\.", "", of)
                    if other == argument:
                        given[other] = [None] if of.startswith("List") else None
                    elif preset is None and of.split("[")[0] == "Union":
                        given[other] = libhair.DensityMapSettings()
                    elif preset is None:
                        given[other] = known.get(of)
                if "self" in given:  # an __init__ is called through its class
                    this = given.pop("self")
                    function_now = (getattr(libhair, name.split(".")[0]) if "__init__" in name
                                    else getattr(this, name.split(".")[1]))
                else:
                    function_now = function
                print(f"{name}({argument}=None)", flush=True)
                tried += 1
                try:
                    function_now(**given)
                except (TypeError, ValueError, RuntimeError):
                    pass
    print("tried", tried)


class Nones(unittest.TestCase):
    def test_none_for_any_argument_ends_no_process(self):
        done = subprocess.run([sys.executable, __file__, "try"], capture_output=True, text=True)
        lines = done.stdout.splitlines()
        self.assertEqual(done.returncode, 0, (lines[-1:], done.stderr[-2000:]))
        self.assertGreater(int(lines[-1].split()[1]), 60)

    def test_none_is_no_object(self):
        strands = libhair.Strands(wavy(20))
        shadow_map = libhair.DensityMap(libhair.DensityMapSettings(), LIGHT)
        roots = strands.roots()
        for call in [
            lambda: libhair.DistanceField(None),
            lambda: libhair.place_head(None, roots),
            lambda: shadow_map.occlude(None),
            lambda: libhair.MeshCollider(None),
            lambda: libhair.Simulation(None),
            lambda: small_simulation().change_groom(None),
            lambda: libhair.truth(strands, LIGHT, None),
        ]:
            with self.assertRaises(TypeError):
                call()


if __name__ == "__main__":
    try_all() if sys.argv[1:] == ["try"] else unittest.main()
