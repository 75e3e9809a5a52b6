import { expect, test } from "vitest";

import { en } from "../src/texts/en.js";
import { zh } from "../src/texts/zh.js";

/** All texts by their path; those with values get some. */
function flat(value: unknown, path = ""): [string, string][] {
  if (typeof value === "string") return [[path, value]];
  if (typeof value === "function") {
    const make = value as (...args: unknown[]) => string;
    return [[path, make(...Array.from({ length: make.length }, (_, index) => `<${index}>`))]];
  }
  return Object.entries(value as object).flatMap(([key, each]) => flat(each, `${path}.${key}`));
}

test("both languages have the same texts, with the same values in them", () => {
  const values = (texts: [string, string][]) =>
    texts.map(([path, text]) => [path, [...text.matchAll(/<\d>/g)].map(String).sort()]);
  expect(values(flat(zh))).toEqual(values(flat(en)));
  expect(flat(en).filter(([, text]) => text.trim() === "")).toEqual([]);
});
