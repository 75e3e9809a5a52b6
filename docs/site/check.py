"""Checks a built site: python3 docs/site/check.py build/site

Every link leads to a file of the site, and every anchor to a place on its page. Nothing is requested
from elsewhere: only links that a reader follows may leave the site. A playground has its modules.
"""

import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    """What a page refers to, and the places on it."""

    def __init__(self, text):
        super().__init__()
        self.places = {""}
        self.links = []
        self.requests = []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.places.update(attributes.get(name) or "" for name in ("id", "name"))
        if tag == "a":
            self.links.append(attributes.get("href") or "")
        elif tag == "link":
            self.requests.append(attributes.get("href") or "")
        if "src" in attributes:
            self.requests.append(attributes["src"])


def mistakes_of(site):
    pages = {path: Page(path.read_text(encoding="utf-8")) for path in site.rglob("*.html")}
    for path, page in sorted(pages.items()):
        # The page for what does not exist is served for any address, and counts from the root.
        folder = site if path.name == "404.html" else path.parent
        for target in page.requests:
            if urlsplit(target).netloc:
                yield f"{path}: requests {target} from elsewhere"
        for target in page.links + page.requests:
            parts = urlsplit(target)
            if parts.scheme or parts.netloc or not target:
                continue
            relative = unquote(parts.path)
            file = site / relative.lstrip("/") if relative.startswith("/") else folder / relative
            file = (file if relative else path).resolve()
            if file.is_dir():
                file = file / "index.html"
            if not file.is_file():
                yield f"{path}: leads to {target}, which does not exist"
            elif file in pages and unquote(parts.fragment) not in pages[file].places:
                yield f"{path}: leads to {target}, but there is no such place on that page"
    # Its script asks for them, which no link shows.
    playground = site / "playground" / "index.html"
    for module in ("oncard.wasm", "oncard-full.wasm"):
        if playground.is_file() and not playground.with_name(module).is_file():
            yield f"{playground}: does nothing without {module}, which does not exist"
    for path in sorted(site.rglob("*.css")):
        text = path.read_text(encoding="utf-8")
        for target in re.findall(r"url\([\"']?((?:https?:)?//[^)\"']*)", text):
            yield f"{path}: requests {target} from elsewhere"


def main():
    site = Path(sys.argv[1]).resolve()
    mistakes = list(mistakes_of(site))
    if not (site / "index.html").is_file():
        mistakes.append(f"{site}: there is no site here")
    for mistake in mistakes:
        print(mistake, file=sys.stderr)
    sys.exit(1 if mistakes else 0)


if __name__ == "__main__":
    main()
