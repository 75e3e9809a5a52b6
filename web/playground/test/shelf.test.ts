import { expect, test } from "vitest";

import { openFiles, readShelf, withoutOpen, withProgram, withText } from "../src/store/shelf.js";

const start = { "a.c": "start" };
const shelf = { open: 0, programs: [start] };

test("an edit changes the open program", () => {
  const edited = withText(withProgram(shelf, { "a.c": "other" }), "a.c", "edited");
  expect(edited).toEqual({ open: 1, programs: [start, { "a.c": "edited" }] });
  expect(openFiles(edited)).toEqual({ "a.c": "edited" });
});

test("what was written stays when another program is opened", () => {
  const edited = withText(shelf, "a.c", "mine");
  expect(withProgram(edited, start)).toEqual({ open: 1, programs: [{ "a.c": "mine" }, start] });
});

test("a program that is already there is opened, not added", () => {
  const two = withProgram(shelf, { "a.c": "other" });
  expect(withProgram(two, { "a.c": "start" })).toEqual({ ...two, open: 0 });
});

test("the last program cannot be removed", () => {
  expect(withoutOpen(withProgram(shelf, { "a.c": "other" }))).toEqual(shelf);
  expect(withoutOpen(shelf)).toEqual(shelf);
});

test.each([
  ["nothing", undefined, undefined],
  ["a text", "programs", undefined],
  ["no programs", { open: 0, programs: [] }, undefined],
  ["programs of something else", { open: 0, programs: [{ "a.c": 3 }] }, undefined],
  ["a program without files", { open: 0, programs: [{}] }, undefined],
  ["a place that is not there", { open: 7, programs: [start] }, shelf],
  ["no place", { programs: [start] }, shelf],
])("a kept shelf with %s", (_, value, read) => {
  expect(readShelf(value)).toEqual(read);
});
