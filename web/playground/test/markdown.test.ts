import { expect, test } from "vitest";

import { htmlOf } from "../src/lesson/markdown.js";

test("texts become HTML", () => {
  expect(htmlOf("**a** `b`")).toBe("<p><strong>a</strong> <code>b</code></p>\n");
});

test("HTML stays text", () => {
  expect(htmlOf("<script>alert(1)</script>")).not.toContain("<script>");
  expect(htmlOf('a <img src=x onerror="x()">')).not.toContain("<img");
});

test("scripts cannot be linked, and pictures are not loaded", () => {
  expect(htmlOf("[a](javascript:alert(1))")).not.toContain("href");
  expect(htmlOf("![a](https://example.org/a.png)")).not.toContain("<img");
});

test("links leave the page alone", () => {
  expect(htmlOf("[a](https://example.org)")).toContain('rel="noreferrer noopener" target="_blank"');
});
