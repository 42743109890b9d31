#!/usr/bin/env python3
"""Builds the site: every page of docs/, and the reference of every public header.

  docs/site/build.py OUT          writes OUT/html/index.html; fails on the first undocumented name

Needs Doxygen. Pages that are added to docs/ join by themselves, in the menu under "Use" unless MENU
names them.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
from xml.sax.saxutils import quoteattr

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(HERE))
import site_filter  # noqa: E402

# Pages by file name without ".md"; those that are not there are left out.
MENU = {
    "Start": ["start", "install"],
    "Concepts": ["concepts/strands", "concepts/simulation", "concepts/shadows",
                 "concepts/measuring", "concepts/hair_meshes"],
    "In depth": ["guarantees", "method", "measurements"],
    "Use": ["formats", "python", "c_interface", "blender", "hair_mesh", "level_of_detail"],
}
REFERENCE = """
      <tab type="usergroup" visible="yes" url="[none]" title="Reference">
        <tab type="modules" visible="yes" title="By stage"
             intro="Folder by folder, in the order that data flows:"/>
        <tab type="classlist" visible="yes" title="Types"/>
        <tab type="filelist" visible="yes" title="Headers"/>{more}
      </tab>"""


def layout(pages, c_headers):
    """The top menu. What else Doxygen lays out stays as it is."""
    left = {"index"} | {p for group in MENU.values() for p in group}
    menu = {title: [p for p in group if p in pages] for title, group in MENU.items()}
    menu["Use"] += sorted(p for p in pages if p not in left)
    tabs = ['      <tab type="mainpage" visible="yes" title="libhair"/>']
    for title, group in menu.items():
        tabs.append(f'      <tab type="usergroup" visible="yes" url="[none]" title={quoteattr(title)}>')
        for page in group:
            tabs.append(f'        <tab type="user" url="@ref {site_filter.page_id(pages[page])}" '
                        f'title={quoteattr(site_filter.short_title(pages[page]))}/>')
        tabs.append("      </tab>")
    more = "".join(f'\n        <tab type="user" url="@ref {site_filter.header_page_id(h)}" '
                   f'title={quoteattr(h.name + " for C")}/>' for h in c_headers)
    return ('<doxygenlayout version="1.0">\n  <navindex>\n    ' + "\n".join(tabs) + REFERENCE.format(more=more) +
            "\n  </navindex>\n</doxygenlayout>\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--doxygen", default="doxygen")
    options = parser.parse_args()
    root, out = ROOT, options.out.resolve()
    docs = root / "docs"

    pages = {str(p.relative_to(docs))[:-3]: p for p in site_filter.pages(docs)}
    version = re.search(r"project\(libhair VERSION (\S+)", (root / "CMakeLists.txt").read_text())[1]
    for part in ("html", "xml"):
        shutil.rmtree(out / part, ignore_errors=True)
    out.mkdir(parents=True, exist_ok=True)
    c_headers = site_filter.c_headers(root)
    (out / "layout.xml").write_text(layout(pages, c_headers))
    (out / "c_headers.dox").write_text("".join(
        f"/** \\page {site_filter.header_page_id(h)} {h.name}: the interface for C\n"
        f"    \\include {h.relative_to(root)} */\n" for h in c_headers))

    inputs = [docs / "site" / "stages.dox", out / "c_headers.dox", *pages.values(), *site_filter.public_headers(root)]
    filter_command = f"{sys.executable} {docs / 'site' / 'site_filter.py'}"
    settings = {
        "PROJECT_NUMBER": version,
        "INPUT": " ".join(f'"{p}"' for p in inputs),
        "USE_MDFILE_AS_MAINPAGE": docs / "index.md",
        "OUTPUT_DIRECTORY": out,
        "EXAMPLE_PATH": root,
        "LAYOUT_FILE": out / "layout.xml",
        "HTML_FOOTER": docs / "site" / "footer.html",
        "HTML_EXTRA_STYLESHEET": docs / "site" / "site.css",
        "STRIP_FROM_PATH": root,
        "STRIP_FROM_INC_PATH": root,
        "FILTER_PATTERNS": f'"*.md={filter_command}" "*.h={filter_command}"',
        "GENERATE_TAGFILE": out / "libhair.tag",
    }
    text = (docs / "Doxyfile").read_text()
    text += "".join(f"{key} = {value}\n" for key, value in settings.items())
    done = subprocess.run([options.doxygen, "-"], input=text, text=True, cwd=root,
                          env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
    if done.returncode != 0:
        return done.returncode
    shutil.copytree(docs / "images", out / "html" / "images")
    print(out / "html" / "index.html")
    return 0


if __name__ == "__main__":
    sys.exit(main())
