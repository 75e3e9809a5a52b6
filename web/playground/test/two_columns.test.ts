import { expect, test } from "vitest";

import { shownAfter } from "../src/two_columns/shown.js";

const row = { file: "p.c", line: 1, text: "int x;", card: "int x;", card_line: 1 };
const good = { compiled: true, diagnostics: [], rows: [row] };
const mistaken = { compiled: false, diagnostics: [] };

test("a program with mistakes keeps its last rows, until they are mended", () => {
  const first = shownAfter(undefined, "p", good);
  expect(first).toEqual({ program: "p", rows: [row], state: "fresh" });
  const broken = shownAfter(first, "p", mistaken);
  expect(broken).toEqual({ program: "p", rows: [row], state: "broken" });
  // Also where the engine refuses, for example a scenario.
  expect(shownAfter(broken, "p", undefined)).toEqual(broken);
  expect(shownAfter(broken, "p", good)).toEqual(first);
});

test("another program has nothing to do with them", () => {
  const first = shownAfter(undefined, "p", good);
  const other = { program: "q", rows: [], state: "broken" };
  expect(shownAfter(first, "q", mistaken)).toEqual(other);
  expect(shownAfter(undefined, "q", mistaken)).toEqual(other);
});

test("what is not structured C becomes nothing else", () => {
  const first = shownAfter(undefined, "p", good);
  const plain = { compiled: true, diagnostics: [] };
  expect(shownAfter(first, "p", plain)).toEqual({ program: "p", rows: [], state: "plain" });
});
