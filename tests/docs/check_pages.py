#!/usr/bin/env python3
"""Do the pages hold? Prints what does not, and fails if anything is printed.

  check_pages.py markdown ROOT          README.md, docs/ and every other page: each relative link leads to
                                        a file and to a heading that is there, each picture is there,
                                        external links look like links, and each code block with a
                                        comment "code: FILE" before it stands in that file, line by line
  check_pages.py site ROOT OUT          the site that docs/site/build.py wrote: each link and picture
                                        leads somewhere, each public header and each of its enumerators
                                        is in the reference, each page is in the menu
"""
import html.parser
import pathlib
import re
import sys
import urllib.parse
import xml.etree.ElementTree

EXTERNAL = re.compile(r"https?://[\w.-]+\.[a-z]{2,}(:\d+)?(/[^\s<>\"]*)?$|mailto:[^\s@]+@[\w.-]+$")
BLOCK = re.compile(r"<!-- code: (\S+) -->\n```\w*\n(.*?)```", re.S)


def own_pages(root):
    """Every page but those in what the scripts leave at the top (build, out) and in hidden folders."""
    for top in sorted(root.iterdir()):
        if top.name in ("build", "out") or top.name.startswith("."):
            continue
        for page in sorted(top.rglob("*.md")) if top.is_dir() else [top] if top.suffix == ".md" else []:
            yield page


def check_markdown(root):
    texts = {f: f.read_text() for f in own_pages(root)}
    if root / "README.md" not in texts:
        yield f"{root}: there is no README.md"
    anchors = {f.resolve(): set(site_filter.slugs(text)) for f, text in texts.items()}
    for file, text in texts.items():
        where = file.relative_to(root)
        prose = site_filter.COMMENT.sub("", site_filter.FENCE.sub("", text))
        prose = re.sub(r"^( {4}|\t).*$", "", prose, flags=re.M)
        for image, _, target in site_filter.LINK.findall(prose):
            if re.match(r"[a-z]+:", target):
                if not EXTERNAL.match(target):
                    yield f"{where}: {target} does not look like a link"
                continue
            path, _, anchor = target.partition("#")
            there = (file.parent / urllib.parse.unquote(path)).resolve() if path else file.resolve()
            if not there.exists():
                yield f"{where}: {target}: there is no such file"
            elif image and not there.is_file():
                yield f"{where}: {target} is no picture"
            elif anchor and anchor not in anchors.get(there, ()):
                yield f"{where}: {target}: there is no such heading"
        for source, code in BLOCK.findall(text):
            if not (root / source).is_file():
                yield f"{where}: {source}: there is no such file"
            elif plain(code) not in plain((root / source).read_text()):
                yield f"{where}: a code block is not, line by line, in {source}:\n{code}"
        if text.count("<!-- code:") != len(BLOCK.findall(text)):
            yield f"{where}: a comment names code, and no block of code follows"


def plain(code):
    """Lines without their indentation: a program's code stands in a function, a page's does not."""
    return "\n" + "".join(line.strip() + "\n" for line in code.strip().split("\n"))


class Page(html.parser.HTMLParser):
    def __init__(self, file):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(file.read_text(errors="replace"))

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        for name in ("id", "name"):
            if attributes.get(name):
                self.anchors.add(attributes[name])
        for name in ("href", "src", "data"):
            if attributes.get(name):
                self.links.append(attributes[name])


def check_site(root, out):
    site = out / "html"
    pages = {f.resolve(): Page(f) for f in sorted(site.glob("*.html"))}
    if site.resolve() / "index.html" not in pages:
        yield f"{site}: there is no site"
    for file, page in pages.items():
        for link in page.links:
            if link.startswith(("javascript:", "data:")):
                continue
            if re.match(r"[a-z]+:", link):
                if not EXTERNAL.match(link):
                    yield f"{file.name}: {link} does not look like a link"
                continue
            path, _, anchor = link.partition("#")
            there = (file.parent / urllib.parse.unquote(path)).resolve() if path else file
            if not there.is_file():
                yield f"{file.name}: {link}: there is no such file"
            elif anchor and there in pages and urllib.parse.unquote(anchor) not in pages[there].anchors:
                yield f"{file.name}: {link}: there is no such place"

    tags = xml.etree.ElementTree.parse(out / "libhair.tag").getroot()
    documented = {c.findtext("path") + c.findtext("name")
                  for c in tags.iter("compound") if c.get("kind") == "file"}
    for header in site_filter.public_headers(root):
        if not any(d.endswith(str(header.relative_to(root))) for d in documented):
            yield f"{header.relative_to(root)} is not in the reference"

    for header in site_filter.c_headers(root):
        if not (site / f"{site_filter.header_page_id(header)}.html").is_file():
            yield f"{header.relative_to(root)} is not in the reference"

    # Doxygen does not ask for words on these.
    for file in sorted((out / "xml").glob("*.xml")):
        for value in xml.etree.ElementTree.parse(file).iter("enumvalue"):
            words = [value.find(d) for d in ("briefdescription", "detaileddescription")]
            if not any(w is not None and "".join(w.itertext()).strip() for w in words):
                yield f"{file.name}: the enumerator {value.findtext('name')} is not documented"

    menu = (site / "menudata.js").read_text()
    for page in site_filter.pages(root / "docs"):
        address = "index.html" if page.name == "index.md" else f"{site_filter.page_id(page)}.html"
        if address not in menu:
            yield f"docs/{page.relative_to(root / 'docs')} is not in the menu"


def main():
    global site_filter
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[2]).resolve()
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(root / "docs" / "site"))
    import site_filter
    wrong = list(check_markdown(root) if sys.argv[1] == "markdown"
                 else check_site(root, pathlib.Path(sys.argv[3])))
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
