import { parseLesson } from "@oncard/lessons";
import { expect, test } from "vitest";

function mistakesOf(value: unknown) {
  const parsed = parseLesson(value);
  return "mistakes" in parsed ? parsed.mistakes : [];
}

const tooMany = [
  {
    where: "",
    message: { en: "it has more than 1000 values", zh: "其中的值超过 1000 个" },
  },
];

/** Lists in lists. */
function nested(depth: number): unknown {
  let value: unknown = 1;
  for (let level = 0; level < depth; ++level) value = [value];
  return value;
}

test.each([
  ["a long list", { hints: Array(1_000_000).fill(0) }],
  ["a large table", Object.fromEntries(Array.from({ length: 1001 }, (_, i) => [`key${i}`, 0]))],
  ["many lists", { hints: Array(30).fill(Array(40).fill(0)) }],
  ["lists in lists", { hints: nested(100_000) }],
])("%s is refused before a mistake is noted for each value", (_, value) => {
  expect(mistakesOf(value)).toEqual(tooMany);
});

test("a place in a table of files is named by the file", () => {
  expect(mistakesOf({ files: { "a~b/c.c": 1 } })).toContainEqual({
    where: "files.a~b/c.c",
    message: { en: "expected a text", zh: "应为文本" },
  });
});
