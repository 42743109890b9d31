#!/usr/bin/env python3
"""What stands between this project's files and Doxygen, so that both are plain.

Pages of docs/ link each other, sources and pictures by relative paths, which any forge follows. Doxygen
wants its own words for that: headings get the names that forges give them, links to pages, headings and
public headers become references, links to anything else become text. In headers it is the folder that
says which stage a name belongs to.

  site_filter.py FILE       writes what Doxygen is to read instead of FILE
"""
import functools
import html
import os
import pathlib
import re
import sys

PUBLIC = "namespace HAIR_API hair {"
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)")
FENCE = re.compile(r"^ {0,3}(```+|~~~+).*?^ {0,3}\1[ \t]*$", re.M | re.S)
COMMENT = re.compile(r"<!--.*?-->", re.S)
HEADING = re.compile(r"^(#{1,6}) +(.*?) *#*$", re.M)
KEPT = re.compile(r"<tt>.*?</tt>|\[(?:[^\[\]]|\[[^\]]*\])*\]\([^)]*\)|<img [^>]*>|^#.*$", re.M)
SPAN = re.compile(r"(?<!`)`([^`\n]+)`(?!`)")


def pages(docs):
    """Every page, docs/*.md and docs/concepts/*.md."""
    return sorted(docs.glob("*.md")) + sorted(docs.glob("concepts/*.md"))


def public_headers(root):
    """Headers that are installed: those that say HAIR_API."""
    return [h for h in sorted((root / "libhair").rglob("*.h")) if PUBLIC in h.read_text()]


def c_headers(root):
    """Headers for C, with comments of their own kind: the reference shows them as they are."""
    return [h for h in sorted((root / "libhair").rglob("*.h")) if 'extern "C" {' in h.read_text()]


def header_page_id(file):
    return "header_" + re.sub(r"\W", "_", str(file.relative_to(root_of(file) / "libhair")))


def root_of(file):
    return next(p for p in file.resolve().parents if (p / "docs" / "Doxyfile").is_file())


def page_id(file):
    """The name of a page for Doxygen: page_concepts_shadows."""
    relative = file.resolve().relative_to(root_of(file) / "docs")
    return "page_" + re.sub(r"\W", "_", str(relative)[:-3])


def title(file):
    return HEADING.search(file.read_text())[2]


def short_title(file):
    """For the menu: what stands before a colon."""
    return title(file).split(":")[0]


def slug(heading):
    """The anchor that forges give a heading."""
    text = re.sub(r"[`*]|\[|\]\([^)]*\)", "", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def slugs(text):
    """Of every heading of a page, in order; the second of a name gets -1, the third -2."""
    seen, names = {}, []
    for _, heading in HEADING.findall(COMMENT.sub("", FENCE.sub("", text))):
        name = slug(heading)
        count = seen.get(name, 0)
        seen[name] = count + 1
        names.append(name if count == 0 else f"{name}-{count}")
    return names


@functools.cache
def known_names(root):
    """Types and functions of the public headers: what a code span may be a link to."""
    names = set()
    for header in public_headers(root):
        text = header.read_text()
        text = text[text.index(PUBLIC):]
        text = re.sub(r"namespace detail \{.*?\n\}  // namespace detail", "", text, flags=re.S)
        names.update(re.findall(r"^(?:struct|class|enum class) (\w+)\b[^;\n]*\{", text, re.M))
        names.update(re.findall(r"^(?!using|return)[\w:][\w:<>,& *]*[ &*](\w+)\(", text, re.M))
    return names


def in_text(text, replace):
    """Applies `replace` to all of a page but code blocks and comments."""
    parts, at = [], 0
    for block in sorted([*FENCE.finditer(text), *COMMENT.finditer(text)], key=lambda m: m.start()):
        if block.start() < at:
            continue
        parts += [replace(text[at:block.start()]), block[0]]
        at = block.end()
    return "".join([*parts, replace(text[at:])])


def page_for_doxygen(file, text):
    root = root_of(file)
    headers = {str(h) for h in public_headers(root)}
    names = iter(slugs(text))
    first = True

    def heading(match):
        nonlocal first
        name, here = next(names), page_id(file)
        label = here if first else f"{here}_{name}"
        first = False
        return f"{match[1]} {match[2]} {{#{label}}}"

    def link(match):
        image, label, target = match.groups()
        label = " ".join(label.split())  # Doxygen does not know one of two lines
        if re.match(r"[a-z]+:", target):
            return match[0]
        path, _, anchor = target.partition("#")
        there = pathlib.Path(os.path.normpath(file.parent / path)) if path else file
        if image:
            source = html.escape(os.path.relpath(there, root / "docs"))
            return f'<img src="{source}" alt="{html.escape(label)}"/>'
        if there.suffix == ".md" and there in pages(root / "docs"):
            if there == root / "docs" / "index.md":
                return f"[{label}](@ref index)"
            same = anchor and slugs(there.read_text())[0] != anchor
            return f"[{label}](@ref {page_id(there)}{'_' + anchor if same else ''})"
        if str(there) in headers:
            return reference(label.strip("`"), there.relative_to(root))
        if there in c_headers(root):
            return reference(label.strip("`"), header_page_id(there))
        return label

    def reference(code, name):
        return f'<tt>@ref {name} "{code}"</tt>'

    def span(match):
        """`shadow/density_map.h`, `chooseShadow` and `Filter::Centred` lead to what they name."""
        code = match[1]
        if f"{root}/libhair/{code.removeprefix('libhair/')}" in headers:
            return reference(code, f"libhair/{code.removeprefix('libhair/')}")
        name = re.match(r"(?:hair::)?(\w+)(?:::\w+)*(?:\(.*\))?$", code)
        if name and name[1] in known_names(root):
            return reference(code, f"hair::{name[1]}")
        return match[0]

    def spans(part):
        # Not in headings, and not in what is a link or a picture already.
        at, out = 0, []
        for kept in KEPT.finditer(part):
            out += [SPAN.sub(span, part[at:kept.start()]), kept[0]]
            at = kept.end()
        return "".join([*out, SPAN.sub(span, part[at:])])

    return in_text(text, lambda part: HEADING.sub(heading, spans(LINK.sub(link, part))))


def prose(line):
    """Words that begin a sentence are no types, and "et al." does not end one."""
    code, mark, words = line.partition("///")
    words = re.sub(r"(?<![\w%`:])(Hair|Light|Wind|Head|Motion|Deposit|Filter|Style|Truth)(?![\w:])",
                   r"%\1", words)
    return code + mark + words.replace("et al. ", "et al.\\ ")


def header_for_doxygen(file, text):
    """Same lines; the file is documented, and its names belong to the group of its folder."""
    folder = file.resolve().relative_to(root_of(file) / "libhair").parts[0]
    # A header beside the folders is about all of them.
    stage = "stage_simulation" if folder.endswith(".h") else f"stage_{folder}"
    text = "\n".join(prose(line) if "///" in line else line for line in text.split("\n"))
    # Doxygen announces private nested types, and then has no place for them.
    text = re.sub(r"^ private:$(.*?)^\};$", r" private: /** @cond */\1/** @endcond */ };", text,
                  flags=re.M | re.S)
    text = text.replace(PUBLIC, f"{PUBLIC} /** \\addtogroup {stage} */ /** @{{ */", 1)
    head, end, tail = text.rpartition("}  // namespace hair")
    return f"/** \\file */ {head}/** @}} */ {end}{tail}"


def main():
    file = pathlib.Path(sys.argv[1]).resolve()
    text = file.read_text()
    sys.stdout.reconfigure(encoding="utf-8")
    sys.stdout.write(page_for_doxygen(file, text) if file.suffix == ".md"
                     else header_for_doxygen(file, text))


if __name__ == "__main__":
    main()
