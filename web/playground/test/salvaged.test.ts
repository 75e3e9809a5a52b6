import { expect, test } from "vitest";

import {
  isKeptSettings,
  isKeptShelf,
  isOpenHints,
  isSolvedLessons,
} from "../src/store/kept_schema.js";
import { salvaged } from "../src/store/salvaged.js";

test("what is right is left as it is", () => {
  const settings = { language: "zh", theme: "dark", speed: 0 };
  expect(salvaged(isKeptSettings, { ...settings })).toEqual(settings);
});

test.each([
  ["a property", isKeptSettings, { language: "de", theme: "dark" }, { theme: "dark" }],
  ["elements of a list", isSolvedLessons, ["a", 1, null, "b", {}], ["a", "b"]],
  ["values of a table", isOpenHints, { a: 2, b: "2", "c/~d": -1 }, { a: 2 }],
  [
    "a part of a part",
    isKeptShelf,
    { open: "1", programs: [{ "a.c": "", "b.c": 1 }, 7, { "c.c": "" }] },
    { programs: [{ "a.c": "" }, { "c.c": "" }] },
  ],
])("%s that are wrong are left out", (_, isType, value, right) => {
  expect(salvaged<unknown>(isType, value)).toEqual(right);
});

test.each([
  ["nothing", undefined],
  ["null", null],
  ["a text", "x"],
  ["a table without what it needs", { open: 1 }],
  ["a list that must have an element", { programs: [1, {}] }],
])("of %s nothing is left", (_, value) => {
  expect(salvaged(isKeptShelf, value)).toBeUndefined();
});
