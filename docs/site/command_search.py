"""Lets the search of the site find commands by their names.

The tables of commands have a row for each. Every row becomes a place of its own that a link can lead
to, and an entry of the index with the command as its title: titles come before mentions elsewhere.
"""

import json
import re
from html import unescape
from pathlib import Path

PAGES = re.compile(r"(^|/)commands[^/]*\.md$")
# The number, the prototype, and the rest of a row.
ROW = re.compile(r"<tr>\s*<td[^>]*>\d+</td>\s*<td[^>]*><code>((\w+)\(.*?)</tr>", re.DOTALL)


def with_places(html):
    """The table with a place at the prototype of each command."""
    return ROW.sub(lambda row: row[0].replace("<code>", f'<code id="{row[2]}">', 1), html)


def entries_of(html, location):
    """What the index shall know of the commands of a page."""
    for row in ROW.finditer(html):
        cells = [unescape(re.sub("<[^>]+>", " ", cell)).strip() for cell in row[1].split("</td>")]
        text = " · ".join(cell for cell in cells if cell)
        yield {"location": f"{location}#{row[2]}", "title": row[2], "text": text}


ENTRIES = []


def on_pre_build(**_):
    ENTRIES.clear()


def on_page_content(html, page, **_):
    if not PAGES.search(page.file.src_path):
        return html
    # A name is found once, in English; the Chinese page is found by its words.
    if not page.file.src_path.endswith(".zh-CN.md"):
        ENTRIES.extend(entries_of(html, page.url))
    return with_places(html)


def on_post_build(config):
    path = Path(config["site_dir"]) / "search" / "search_index.json"
    index = json.loads(path.read_text(encoding="utf-8"))
    index["docs"] += ENTRIES
    path.write_text(json.dumps(index, ensure_ascii=False), encoding="utf-8")
