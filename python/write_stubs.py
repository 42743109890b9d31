"""Writes libhair/_libhair.pyi and libhair/__init__.pyi from what the extension says of itself.

usage: PYTHONPATH=<build>/python python3 write_stubs.py [--check]

pybind11 puts a signature before every docstring; this turns those into the syntax of stubs.
--check: writes nothing, and fails where the files are not what it would write.
"""

import pathlib
import re
import sys

# The package that was built, not the folder beside this file.
sys.path = [p for p in sys.path if pathlib.Path(p).resolve() != pathlib.Path(__file__).parent]
from libhair import _libhair  # noqa: E402

FOLDER = pathlib.Path(__file__).parent / "libhair"
HEADER = '''"""Written by write_stubs.py; do not edit."""

import os
from typing import Any, Callable, Iterator, Literal, Optional, Sequence, Union, overload

import numpy
from numpy.typing import NDArray

'''
# Of the same thing, what is given may be of more types than what is returned.
GIVEN = {"Vec3": "_Numbers", "Quaternion": "_Numbers", "Transform": "_Place"}
ALIASES = '''_Numbers = Union[Sequence[float], NDArray[Any]]
_Place = Union["Transform", Sequence[Sequence[float]], NDArray[Any]]
Vec3 = tuple[float, float, float]
IVec3 = tuple[int, int, int]
Quaternion = tuple[float, float, float, float]
'''


def python_type(name, given):
    name = name.replace("libhair._libhair.", "")
    name = re.sub(r"numpy\.ndarray\b(?!\[)", "NDArray[Any]", name).replace("numpy.ndarray", "NDArray").replace("os.PathLike", "Union[str, os.PathLike[str]]")
    name = re.sub(r"\b(List|Tuple|Dict|Set)\[", lambda m: m[1].lower() + "[", name)
    name = re.sub(r"\b(object|sequence|args|kwargs)\b", "Any", name)
    name = re.sub(r"\bfunction\b", "Callable[..., Any]", name)
    if given:
        name = re.sub(r"\blist\[", "Sequence[", name).replace("tuple[Light, ...]", "Sequence[Light]")
        for of, wider in GIVEN.items():
            name = re.sub(rf"(?<![\w\"]){of}\b", wider, name)
    return name


def arguments(text):
    """The arguments of a signature, split at its outer commas."""
    parts, depth, start, quoted = [], 0, 0, False
    for i, c in enumerate(text):
        if c in "'\"":
            quoted = not quoted
        if quoted:
            continue
        depth += (c in "([{<") - (c in ")]}>" and text[i - 1 : i + 1] != "->")
        if c == "," and depth == 0:
            parts.append(text[start:i].strip())
            start = i + 1
    last = text[start:].strip()
    return parts + [last] if last else parts


def argument(text, in_class, first):
    if text in ("*", "/"):
        return text
    if text.startswith("*"):  # *args, **kwargs
        return text + ": Any"
    name, _, rest = text.partition(": ")
    if in_class and first and name in ("self", "arg0"):
        return "self"
    kind, default, _ = rest.partition(" = ")
    kind = python_type(kind, True)
    if default and "None" in rest.partition(" = ")[2][:5] and not kind.startswith("Optional") and kind != "Any":
        kind = f"Optional[{kind}]"
    return f"{name}: {kind}" + (" = ..." if default else "")


def function(name, doc, indent, in_class, static=False):
    """Stubs of a function from its docstring."""
    signatures = re.findall(rf"^(?:\d+\. )?{re.escape(name)}\((.*)\) -> (.+)$", doc, re.M)
    lines = []
    for given, result in signatures:
        if len(signatures) > 1:
            lines.append(f"{indent}@overload")
        if static:
            lines.append(f"{indent}@staticmethod")
        args = [argument(a, in_class and not static, i == 0) for i, a in enumerate(arguments(given))]
        if name in ("__eq__",):
            args, result = ["self", "other: object, /"], "bool"
        if name == "__exit__":
            args = ["self", "*args: Any"]
        if name == "__iter__":
            result = "Iterator[NDArray[Any]]"
        if name == "__enter__":
            result = "thread_limit"
        lines.append(f"{indent}def {name}({', '.join(args)}) -> {python_type(result, False)}: ...")
    return lines


def fields_of(cls):
    return [(f, property_type(cls, f)) for f in getattr(cls, "_fields", ())]


def property_type(cls, name):
    doc = vars(cls)[name].fget.__doc__ or ""
    found = re.search(r"-> (.+)$", doc, re.M)
    kind = python_type(found[1], False) if found else "Any"
    return {"tuple": "tuple[Light, ...]"}.get(kind, kind)


def class_stub(name, cls):
    base = cls.__mro__[1].__name__
    base = {"pybind11_object": "", "object": ""}.get(base, f"({base})")
    lines = [f"class {name}{base}:"]
    fields = fields_of(cls)
    if fields:
        given = ", ".join(f"{f}: {python_type(t, True)} = ..." for f, t in fields)
        lines += [f"    def __init__(self, *, {given}) -> None: ...",
                  f"    def replace(self, *, {given}) -> {name}: ...",
                  "    _fields: tuple[str, ...]", "    __hash__: None  # type: ignore[assignment]"]
    for member, value in sorted(vars(cls).items()):
        if member in ("__module__", "__doc__", "__entries", "_fields", "__hash__") or (
                fields and member in ("__init__", "replace")):
            continue
        if isinstance(value, property):
            kind = property_type(cls, member)
            lines += ["    @property", f"    def {member}(self) -> {kind}: ..."]
            if value.fset:
                lines += [f"    @{member}.setter", f"    def {member}(self, value: {kind}) -> None: ..."]
        elif isinstance(value, staticmethod) or type(value).__name__ in ("staticmethod",):
            lines += function(member, value.__func__.__doc__ or "", "    ", True, static=True)
        elif callable(value) or type(value).__name__ == "instancemethod":
            lines += function(member, getattr(value, "__doc__", "") or "", "    ", True)
    return lines if len(lines) > 1 else [lines[0] + " ..."]


def module_stub():
    lines = [ALIASES.rstrip()]
    for name, words in sorted(_libhair._choices.items()):
        lines.append(f"{name} = Literal[{', '.join(map(repr, words))}]")
    lines += ["__version__: str", "_choices: dict[str, tuple[str, ...]]", ""]
    for name in sorted(n for n in dir(_libhair) if not n.startswith("_")):
        value = getattr(_libhair, name)
        if isinstance(value, type):
            lines += class_stub(name, value) + [""]
        elif callable(value):
            lines += function(name, value.__doc__, "", False) + [""]
        else:
            lines.append(f"{name}: {type(value).__name__}")
    return HEADER + "\n".join(lines) + "\n"


def package_stub():
    names = sorted(n for n in dir(_libhair) if not n.startswith("_"))
    lines = ['"""Written by write_stubs.py; do not edit."""', "", "from . import _libhair as _libhair"]
    lines += [f"from ._libhair import {n} as {n}" for n in ["__version__"] + names]
    lines += ["", "__all__ = ["] + [f'    "{n}",' for n in names] + ["]"]
    return "\n".join(lines) + "\n"


def main():
    check = "--check" in sys.argv
    stale = []
    for file, text in (("_libhair.pyi", module_stub()), ("__init__.pyi", package_stub())):
        path = FOLDER / file
        if check and (not path.exists() or path.read_text() != text):
            stale.append(file)
        elif not check:
            path.write_text(text)
    if stale:
        sys.exit(f"{', '.join(stale)}: not what write_stubs.py writes; run it")


if __name__ == "__main__":
    main()
