import { afterEach, expect, test, vi } from "vitest";

import {
  addLinked,
  lessonNamed,
  lessons,
  markSolved,
  offerLessons,
  openHints,
  takeProgress,
} from "../src/store/lessons.js";
import { ownProgram } from "../src/store/own_program.js";
import { stubStorage } from "./storage.js";

const lessonOf = (id: string) => ({ ...ownProgram, id });

afterEach(() => {
  vi.unstubAllGlobals();
});

test("there are the reader's own program, the page's lessons, and those of links", () => {
  stubStorage({ linked: [lessonOf("linked"), { id: "no lesson" }] });
  offerLessons([lessonOf("a"), lessonOf("b")]);
  expect(lessons.all.value.map(({ id }) => id)).toEqual(["own", "a", "b", "linked"]);
  expect(lessonNamed("b")?.id).toBe("b");
  expect(lessonNamed("c")).toBeUndefined();
  expect(lessonNamed(undefined)).toBeUndefined();
});

test("the first sample is the opening, which is no lesson of the list", () => {
  stubStorage();
  offerLessons([lessonOf("a")], [lessonOf("star"), lessonOf("gear")]);
  expect(lessons.opening.value?.id).toBe("star");
  expect(lessonNamed("star")?.id).toBe("star");
  expect(lessonNamed("gear")).toBeUndefined();
  expect(lessons.listed.value.map(({ id }) => id)).toEqual(["a"]);
});

test("a lesson of a link replaces the one of that name, and is kept", () => {
  stubStorage();
  offerLessons([]);
  addLinked(lessonOf("x"));
  const changed = { ...lessonOf("x"), hints: [{ en: "Look.", zh: "看。" }] };
  addLinked(changed);
  expect(lessons.linked.value).toEqual([changed]);
  offerLessons([]);
  expect(lessons.linked.value).toEqual([changed]);
});

test("progress and hints are kept", () => {
  stubStorage({ solved: ["a", 7], hints: { a: 1, b: "2" } });
  offerLessons([lessonOf("a")]);
  markSolved("b");
  openHints("a", 2);
  offerLessons([lessonOf("a")]);
  expect([...lessons.solved.value]).toEqual(["a", "b"]);
  expect(lessons.openHints.value).toEqual({ a: 2 });
});

test("what was solved in another tab is solved here, too", () => {
  stubStorage({ solved: ["a"] });
  offerLessons([lessonOf("a"), lessonOf("b"), lessonOf("c")]);
  markSolved("b");
  takeProgress("solved", ["a", "c", 7]);
  takeProgress("hints", ["x"]);
  expect([...lessons.solved.value]).toEqual(["a", "b", "c"]);
  takeProgress("linked", [lessonOf("x")]);
  expect(lessonNamed("x")?.id).toBe("x");
});
