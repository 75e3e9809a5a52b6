import { layouts } from "@oncard/lessons";
import { expect, test } from "vitest";

import { arrangementFor } from "../src/store/arrangement.js";
import { panels } from "../src/store/layout.js";

test("every layout has each panel once; the table is there for a failing run alone", () => {
  for (const layout of [undefined, ...layouts]) {
    for (const failing of [false, true]) {
      const { left, middle, right } = arrangementFor(layout, failing);
      const expected = panels.filter((name) => failing || name !== "interleaving");
      expect([...left, ...middle, ...right].sort()).toEqual([...expected].sort());
    }
  }
});

test("the right column begins with what the layout is for", () => {
  const first = (layout?: (typeof layouts)[number]) => arrangementFor(layout, false).right[0];
  expect(first("language")).toBe("values");
  expect(first("threads")).toBe("timeline");
  expect(first("motion")).toBe("machine");
  expect(first()).toBe("machine");
  expect(arrangementFor("motion", false).right[1]).toBe("scope");
});

test("a failing run comes first in every layout", () => {
  for (const layout of [undefined, ...layouts]) {
    expect(arrangementFor(layout, true).right.slice(0, 2)).toEqual(["interleaving", "timeline"]);
  }
});
