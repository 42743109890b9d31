"""Writes the comments of settings in C++ headers as a table for the bindings (src/fields.h).

usage: python3 member_docs.py OUT HEADER ...

Of every struct S with a table of fields (fieldsOf(const S*), libhair/core/fields.h), a row is
{"GuideSettings", "airDrag", "1/s, ..."}; the struct's own comment has the member "". Names of C++
become those of Python: airDrag, air_drag. Fails where a comment states another range than the table.
"""

import pathlib
import re
import sys

STRUCT = re.compile(r"struct (\w+)[^;]*\{$")
MEMBER = re.compile(r"[\w:<>, ]+[\w>] (\w+)\s*(?:=.*|\{.*\})?;$")
ROW = re.compile(r'Field\("(\w+)", &S::\w+(?:,\s*"([^"]*)")?\)')
INTERVAL = re.compile(r"[\[(]-?[\d.e-]+, (?:-?[\d.e-]+|inf)[\])]")


def python_words(text):
    text = re.sub(r" \(k?[a-z]+[A-Z]\w*(?: in [\w.]+)?\)", "", text)  # (a function of C++)
    text = re.sub(r"\b\w+::([A-Z]\w*)", lambda m: f'"{m[1].lower()}"', text)
    text = re.sub(r"\b(\w+)::(\w+)", r"\1.\2", text).replace("`", "")
    text = re.sub(r"\b[a-z]+(?:[A-Z][a-z]+)+\b", lambda m: re.sub("[A-Z]", lambda c: "_" + c[0].lower(), m[0]), text)
    return text + ("" if text.endswith(".") else ".")


def comments_of(text):
    """[struct, member, comment] of every commented member of every struct."""
    structs, before, code, member = [], [], "", None
    for line in text.splitlines():
        line, slashes, after = (part.strip() for part in line.partition("///"))
        if not line and slashes:
            if after.startswith("<") and member:  # a trailing comment goes on
                member[2] += " " + after[1:].strip()
            else:
                before.append(after)
            continue
        if member:
            yield member
            member = None
        if not line:
            before, code = [], ""
        if not line or line.startswith("//"):
            continue
        code = f"{code} {line}".strip()
        if struct := STRUCT.search(code):
            structs.append(struct[1])
            first = before.index("") if "" in before else len(before)  # the first paragraph
            comment = " ".join(before[:first])
            yield [structs[-1], "", comment[: comment.rindex(".") + 1]]
            before, code = [], ""
        elif code == "};" and structs:
            structs.pop()
            code = ""
        elif code.endswith((";", "}", ":", "{")):
            found = MEMBER.fullmatch(code)
            if found and structs and "(" not in code.split("=")[0]:
                member = [structs[-1], found[1], " ".join(before + [after.lstrip("< ")]).strip()]
            before, code = [], ""


def rows_of(header):
    text = header.read_text()
    tables = {}
    for table in re.finditer(r"fieldsOf\(const (\w+)\*\) \{.*?\n\}", text, re.S):
        tables[table[1]] = {name: interval for name, interval in ROW.findall(table[0])}
    for struct, member, doc in comments_of(text):
        ranges = tables.get(struct)
        if ranges is None or not doc or (member and member not in ranges):
            continue
        interval = ranges.get(member, "")
        stated = INTERVAL.search(doc) if interval else None
        if stated and not interval.startswith(stated[0]):
            sys.exit(f"{header}: {struct}::{member}: its comment says {stated[0]}, its table {interval}")
        if interval and not stated and "inf" not in interval:
            doc = doc.rstrip(".") + f"; {interval}"
        quoted = python_words(doc).replace("\\", "\\\\").replace('"', '\\"')
        yield f'{{"{struct}", "{member}", "{quoted}"}},'


def main(out, headers):
    rows = [row for header in headers for row in rows_of(pathlib.Path(header))]
    pathlib.Path(out).write_text("// Written by member_docs.py.\n" + "\n".join(rows) + "\n")


main(sys.argv[1], sys.argv[2:])
