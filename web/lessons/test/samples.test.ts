// What the page opens with.

import { collectSamples } from "@oncard/lessons/samples";
import { expect, test } from "vitest";

const samples = collectSamples();

test("samples have names of their own, texts in both languages, and channels", () => {
  const ids = samples.map(({ lesson }) => lesson.id);
  expect(ids).toHaveLength(10);
  expect(new Set(ids).size).toBe(ids.length);
  for (const { title, text, scope } of samples.map(({ lesson }) => lesson)) {
    expect(title.zh).toMatch(/\p{Script=Han}/u);
    expect(text.zh).toMatch(/\p{Script=Han}/u);
    expect(text.en).not.toBe(text.zh);
    expect(scope).not.toEqual([]);
  }
});

test("a sample has its program and its scenario, under their names", () => {
  const star = samples[0]?.lesson;
  expect(star?.id).toBe("star");
  expect(Object.keys(star?.files ?? {})).toEqual(["star.c", "star.toml"]);
  expect([star?.program, star?.main]).toEqual(["star.c", "star.toml"]);
});
