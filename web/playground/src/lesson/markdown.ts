// Texts of lessons as HTML. HTML in them stays text, and nothing is loaded from elsewhere: a link can
// carry a lesson of anybody's. Tested by test/markdown.test.ts.

import MarkdownIt from "markdown-it";

const markdown = new MarkdownIt({ html: false, linkify: false });
// A picture would be a request to a third party.
markdown.disable("image");
const renderLink =
  markdown.renderer.rules["link_open"] ??
  ((tokens, index, options, _environment, self) => self.renderToken(tokens, index, options));
markdown.renderer.rules["link_open"] = (tokens, index, options, environment, self) => {
  tokens[index]?.attrSet("rel", "noreferrer noopener");
  tokens[index]?.attrSet("target", "_blank");
  return renderLink(tokens, index, options, environment, self);
};

export function htmlOf(text: string): string {
  return markdown.render(text);
}
