import { readFileSync } from "node:fs";

import { expect, test } from "vitest";

/** Rules that cannot speak for themselves. */
const silent = ["pattern", "not", "minProperties", "propertyNames", "minimum", "minItems"];

/** The rules of a schema that say nothing in words, by their places. */
function wordless(schema: unknown, place = "#"): string[] {
  if (typeof schema !== "object" || schema === null) return [];
  const { expected } = schema as { expected?: { en: string; zh: string } };
  const hasWords = Boolean(expected?.en) && /[一-鿿]/.test(expected?.zh ?? "");
  return Object.entries(schema).flatMap(([key, value]) => {
    const here = `${place}/${key}`;
    if (silent.includes(key)) return hasWords ? [] : [here];
    return key === "expected" ? [] : wordless(value, here);
  });
}

test("a rule without words is found", () => {
  const expected = { en: "expected a digit", zh: "应为数字" };
  expect(wordless({ pattern: "[0-9]", expected })).toEqual([]);
  expect(wordless({ items: { pattern: "[0-9]" } })).toEqual(["#/items/pattern"]);
});

// What a browser has kept is read without messages.
test.each(["lessons/src/lesson.schema.json", "playground/src/share/link.schema.json"])(
  "every rule of %s can be told in both languages",
  (path) => {
    const text = readFileSync(new URL(`../../${path}`, import.meta.url), "utf8");
    expect(wordless(JSON.parse(text))).toEqual([]);
  },
);
