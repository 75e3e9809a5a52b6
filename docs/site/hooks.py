"""Gathers the pages of the site, which mkdocs calls before it builds.

mkdocs reads the pages of one folder, but those of this project are in many, and lead to each other
and to programs by relative links. So the pages of the navigation, and whatever they lead to, page by
page, are copied to build/docs, in the same folders: every link stays what it is. With --strict,
mkdocs fails at a link without a target; check.py then checks the anchors.
"""

import re
import shutil
from pathlib import Path

LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")
# Where the playground is built, and its place in the page that shows it.
PLAYGROUND = Path("web/playground/dist/page")
MODULES = ("oncard.wasm", "oncard-full.wasm")
PLAYGROUND_PLACE = "<!-- playground -->"
FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)


def links_of(page):
    """The targets of the links to files, from the text of a page; links in code are none."""
    targets = LINK.findall(FENCE.sub("", page))
    return [target for target in targets if not re.match(r"[a-z]+:", target)]


def reachable(root, first):
    """The files that links lead to from `first`, those included, relative to `root`."""
    found = {}
    waiting = [root / page for page in first]
    while waiting:
        path = waiting.pop().resolve()
        if path in found or not path.is_file() or root not in path.parents:
            continue
        found[path] = path.relative_to(root)
        if path.suffix == ".md":
            page = path.read_text(encoding="utf-8")
            waiting += [path.parent / target for target in links_of(page)]
    return sorted(found.values())


def pages_of(navigation):
    """The pages that a part of the navigation names."""
    if isinstance(navigation, str):
        return [navigation]
    parts = navigation.values() if isinstance(navigation, dict) else navigation
    return [page for part in parts for page in pages_of(part)]


def on_config(config):
    root = Path(config["config_file_path"]).resolve().parent
    staged = root / "build" / "docs"
    shutil.rmtree(staged, ignore_errors=True)
    for path in reachable(root, pages_of(config["nav"])):
        (staged / path).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(root / path, staged / path)
    shutil.copyfile(Path(__file__).with_name("site.css"), staged / "site.css")
    config["docs_dir"] = str(staged)
    return config


def has_playground(root):
    """Whether it was built with its modules: without them it would be a page that does nothing."""
    return all((root / PLAYGROUND / name).is_file() for name in ("index.html", *MODULES))


def playground_in(root):
    """What the page about the playground shows: the playground, or how one gets it."""
    if not has_playground(root):
        return "This site was built without the playground: build it first, then the site."
    address = "../playground/index.html"
    return (
        f'<iframe src="{address}" title="playground" style="width: 100%; height: 85vh"></iframe>\n\n'
        f'<a href="{address}">In a page of its own</a>'
    )


def on_post_build(config):
    root = Path(config["config_file_path"]).resolve().parent
    published = Path(config["site_dir"]) / "playground"
    # That of an earlier build, whose module may be gone.
    shutil.rmtree(published, ignore_errors=True)
    if has_playground(root):
        shutil.copytree(root / PLAYGROUND, published)


def without_escapes_in_tables(markdown):
    """In tables, GitHub wants a bar in code escaped; Python-Markdown shows the backslash."""
    code = re.compile(r"(`+)(.+?)\1")
    rows = (
        code.sub(lambda span: span[0].replace(r"\|", "|"), line) if line.startswith("|") else line
        for line in markdown.split("\n")
    )
    return "\n".join(rows)


def on_page_markdown(markdown, config, **_):
    root = Path(config["config_file_path"]).resolve().parent
    return without_escapes_in_tables(markdown).replace(PLAYGROUND_PLACE, playground_in(root))


def on_post_page(output, page, **_):
    """Chinese pages say that they are: fonts and screen readers choose by it."""
    chinese = page.file.src_path.endswith(".zh-CN.md")
    return output.replace('<html lang="en"', '<html lang="zh-CN"', 1) if chinese else output
