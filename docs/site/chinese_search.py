"""Lets the search of the site find Chinese words.

The search knows words by the blanks between them, and keeps of each what is written in Latin letters.
Chinese has no blanks. So every Chinese character becomes a word of its own, in the index by invisible
blanks around it. A query asks for pages with all of its Chinese characters, and for words that begin
like its Latin ones.
"""

import json
import re
from pathlib import Path

INVISIBLE = "\u200b"
CHINESE = re.compile("([\u3400-\u9fff])")

# Words are divided here, instead of being rid of what is not Latin.
SEPARATOR = "[\\s\\-,.;:!?()\\[\\]{}<>\"'`/=，。；：！？、（）“”《》" + INVISIBLE + "]+"
TRIMMING = '"search.config.pipeline": "trimmer, stopWordFilter"'
NO_TRIMMING = '"search.config.pipeline": "stopWordFilter"'

# The theme asks this function for what is searched.
TRANSFORM = """<script>
var __search = {
  transform: (query) =>
    query
      .split(/([\\u3400-\\u9fff])|[^\\w\\u3400-\\u9fff]+/)
      .filter(Boolean)
      .map((word) => (/^\\w/.test(word) ? word + "*" : "+" + word))
      .join(" "),
};
</script>
"""


def divided(text):
    """The text with every Chinese character as a word of its own."""
    return CHINESE.sub(INVISIBLE + r"\1" + INVISIBLE, text)


def on_post_page(output, **_):
    return output.replace(TRIMMING, NO_TRIMMING).replace("</head>", TRANSFORM + "</head>", 1)


def on_post_template(output_content, template_name, **_):
    """The page for what does not exist is made from a template of its own."""
    return on_post_page(output_content) if template_name.endswith(".html") else output_content


def on_post_build(config):
    path = Path(config["site_dir"]) / "search" / "search_index.json"
    index = json.loads(path.read_text(encoding="utf-8"))
    index["config"]["separator"] = SEPARATOR
    for place in index["docs"]:
        place["title"] = divided(place["title"])
        place["text"] = divided(place["text"])
    path.write_text(json.dumps(index, ensure_ascii=False), encoding="utf-8")
