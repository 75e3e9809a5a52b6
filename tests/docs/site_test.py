"""The scripts of the documentation's site: python3 tests/docs/site_test.py"""

import json
import re
import sys
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "docs" / "site"))
import check  # noqa: E402
import chinese_search  # noqa: E402
import command_search  # noqa: E402
import hooks  # noqa: E402


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name).resolve()

    def write(self, **files):
        for name, text in files.items():
            path = self.root / name.replace("__", "/").replace("_", ".")
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")


class Gathering(Folder):
    def test_links_are_those_to_files_outside_of_code(self):
        page = "[a](a.md) ![b](b/b.svg) [c](c.md#d)\n```\n[e](e.md)\n```\n[f](http://f) [g](#g)\n"
        self.assertEqual(hooks.links_of(page), ["a.md", "b/b.svg", "c.md"])

    def test_pages_are_followed_from_page_to_page(self):
        self.write(a_md="[b](x/b.md)", x__b_md="[c](../c.c) [a](../a.md)", c_c="[d](d.md)", d_md="")
        found = [str(path) for path in hooks.reachable(self.root, ["a.md"])]
        self.assertEqual(found, ["a.md", "c.c", "x/b.md"])

    def test_files_that_do_not_exist_or_lie_outside_are_left_to_mkdocs(self):
        self.write(x__a_md="[b](b.md) [c](../c.md)", c_md="")
        found = [str(path) for path in hooks.reachable(self.root / "x", ["a.md"])]
        self.assertEqual(found, ["a.md"])

    def test_the_navigation_names_pages_at_any_depth(self):
        navigation = ["a.md", {"B": "b.md"}, {"C": [{"D": "d.md"}, "e.md"]}]
        self.assertEqual(hooks.pages_of(navigation), ["a.md", "b.md", "d.md", "e.md"])

    def test_bars_in_the_code_of_tables_need_no_backslash(self):
        page = "| `a \\| b` | c \\| d |\n\n`e \\| f`"
        self.assertEqual(hooks.without_escapes_in_tables(page), "| `a | b` | c \\| d |\n\n`e \\| f`")

    def test_the_playground_is_shown_and_copied_if_it_was_built(self):
        config = {"config_file_path": str(self.root / "mkdocs.yml"), "site_dir": str(self.root / "s")}
        page = f"# P\n\n{hooks.PLAYGROUND_PLACE}\n"
        self.assertIn("without the playground", hooks.on_page_markdown(page, config))
        hooks.on_post_build(config)
        self.assertFalse((self.root / "s").exists())
        self.write(web__playground__dist__page__index_html="<p>")
        # Without its modules the page would do nothing.
        self.write(web__playground__dist__page__oncard_wasm="")
        self.assertIn("without the playground", hooks.on_page_markdown(page, config))
        hooks.on_post_build(config)
        self.assertFalse((self.root / "s").exists())
        self.write(**{"web__playground__dist__page__oncard-full_wasm": ""})
        self.assertIn('<iframe src="../playground/index.html"', hooks.on_page_markdown(page, config))
        hooks.on_post_build(config)
        self.assertTrue((self.root / "s" / "playground" / "index.html").is_file())

    def test_no_page_leads_to_the_playground_by_itself(self):
        # It may be missing: only the place of the playground has a frame and a link, if it was built.
        root = Path(__file__).resolve().parents[2]
        navigation = re.findall(r": (\S+\.md)$", (root / "mkdocs.yml").read_text(encoding="utf-8"), re.M)
        config = {"config_file_path": str(self.root / "mkdocs.yml")}
        places = 0
        for path in hooks.reachable(root, navigation):
            if path.suffix != ".md":
                continue
            page = (root / path).read_text(encoding="utf-8")
            places += hooks.PLAYGROUND_PLACE in page
            shown = hooks.on_page_markdown(page, config)
            self.assertNotIn("playground/index.html", shown, path)
            self.assertNotIn("<iframe", shown, path)
        self.assertEqual(places, 1)

    def test_an_old_playground_goes_with_its_module(self):
        config = {"config_file_path": str(self.root / "mkdocs.yml"), "site_dir": str(self.root / "s")}
        self.write(web__playground__dist__page__index_html="<p>")
        self.write(s__playground__index_html="<p>")
        hooks.on_post_build(config)
        self.assertFalse((self.root / "s" / "playground").exists())

    def test_chinese_pages_say_that_they_are(self):
        for name, language in (("a.md", "en"), ("a.zh-CN.md", "zh-CN")):
            page = SimpleNamespace(file=SimpleNamespace(src_path=name))
            html = hooks.on_post_page('<html lang="en" class="a">', page)
            self.assertEqual(html, f'<html lang="{language}" class="a">')


class ChineseSearch(Folder):
    def test_every_chinese_character_is_a_word_of_the_index(self):
        index = {"config": {}, "docs": [{"title": "数据 page", "text": "a.b", "location": ""}]}
        path = self.root / "search" / "search_index.json"
        path.parent.mkdir()
        path.write_text(json.dumps(index), encoding="utf-8")
        chinese_search.on_post_build({"site_dir": str(self.root)})
        index = json.loads(path.read_text(encoding="utf-8"))
        separator = re.compile(index["config"]["separator"])
        words = [word for word in separator.split(index["docs"][0]["title"]) if word]
        self.assertEqual(words, ["数", "据", "page"])
        self.assertEqual(separator.split(index["docs"][0]["text"]), ["a", "b"])

    def test_pages_ask_for_words_in_this_way(self):
        page = f"<head></head><script>{{{chinese_search.TRIMMING}}}</script>"
        page = chinese_search.on_post_page(page)
        self.assertIn("__search", page[: page.index("</head>")])
        self.assertNotIn("trimmer", page)


class CommandSearch(Folder):
    TABLE = (
        "<table><tr><td>1</td>\n<td><code>GT_A(short n)</code></td><td>host</td><td>sets &amp; starts</td>"
        "</tr>\n<tr><td>2</td><td><code>GT_B()</code></td><td></td><td>stops</td></tr></table>"
    )

    def page(self, name, html):
        page = SimpleNamespace(file=SimpleNamespace(src_path=name), url="docs/commands.html")
        return command_search.on_page_content(html, page)

    def test_every_command_of_a_table_is_a_place_and_an_entry(self):
        path = self.root / "search" / "search_index.json"
        path.parent.mkdir()
        path.write_text(json.dumps({"docs": [{"location": "", "title": "", "text": ""}]}))
        command_search.on_pre_build()
        html = self.page("docs/commands.md", self.TABLE)
        self.assertIn('<code id="GT_A">GT_A(short n)</code>', html)
        self.assertIn('<code id="GT_B">GT_B()</code>', html)
        self.assertEqual(self.page("docs/commands.zh-CN.md", self.TABLE), html)
        command_search.on_post_build({"site_dir": str(self.root)})
        entries = json.loads(path.read_text(encoding="utf-8"))["docs"][1:]
        self.assertEqual(
            entries,
            [
                {
                    "location": "docs/commands.html#GT_A",
                    "title": "GT_A",
                    "text": "GT_A(short n) · host · sets & starts",
                },
                {
                    "location": "docs/commands.html#GT_B",
                    "title": "GT_B",
                    "text": "GT_B() · stops",
                },
            ],
        )

    def test_other_pages_stay_as_they_are(self):
        command_search.on_pre_build()
        self.assertEqual(self.page("docs/limits.md", self.TABLE), self.TABLE)
        self.assertEqual(command_search.ENTRIES, [])


class Checking(Folder):
    def mistakes(self, **files):
        self.write(**files)
        return [mistake.split(": ", 1)[1] for mistake in check.mistakes_of(self.root)]

    def test_a_good_site_has_no_mistakes(self):
        page = '<h1 id="top">A</h1><a href="x/b.html#p%20q">b</a><a href="#top">t</a><a href="x">x</a>'
        other = '<p id="p q"></p><a href="https://example.com">e</a><a href="../index.html">i</a>'
        self.assertEqual(self.mistakes(index_html=page, x__b_html=other, x__index_html=""), [])

    def test_a_link_needs_a_target(self):
        self.assertEqual(
            self.mistakes(index_html='<a href="b.html">b</a><img src="c.svg">'),
            ["leads to b.html, which does not exist", "leads to c.svg, which does not exist"],
        )

    def test_a_frame_needs_its_page(self):
        frame = '<iframe src="../playground/index.html"></iframe>'
        self.assertEqual(
            self.mistakes(docs__playground_html=frame),
            ["leads to ../playground/index.html, which does not exist"],
        )

    def test_a_playground_needs_its_modules(self):
        self.write(**{"playground__oncard-full_wasm": ""})
        self.assertEqual(
            self.mistakes(playground__index_html="<p>"),
            ["does nothing without oncard.wasm, which does not exist"],
        )
        self.assertEqual(self.mistakes(playground__oncard_wasm=""), [])

    def test_an_anchor_needs_a_place(self):
        self.assertEqual(
            self.mistakes(index_html='<a href="b.html#c">b</a>', b_html='<p id="d"></p>'),
            ["leads to b.html#c, but there is no such place on that page"],
        )

    def test_nothing_comes_from_elsewhere(self):
        page = '<script src="https://a/b.js"></script><link href="//c/d.css"><iframe src="http://e">'
        style = 'a { background: url("https://f/g.png") url(data:image/png;base64,) url(h.png) }'
        self.assertEqual(
            self.mistakes(index_html=page, a_css=style),
            [
                f"requests {target} from elsewhere"
                for target in ("https://a/b.js", "//c/d.css", "http://e", "https://f/g.png")
            ],
        )


if __name__ == "__main__":
    unittest.main()
