import lzString from "lz-string";
import { expect, test, vi } from "vitest";

import { readLink, type Shared, writeLink } from "../src/share/link.js";
import { packedRun } from "./packed_run.js";

const shared: Shared = {
  lesson: "first-axis",
  files: { "start.c": "int x; // 位置\n", "task.toml": 'program = "start.c"\n' },
  program: "start.c",
  main: "task.toml",
  language: "zh",
};

const own = {
  version: 1,
  id: "mine",
  title: { en: "Mine" },
  text: { en: "Do it." },
  hints: [],
  files: shared.files,
  program: "start.c",
  main: "task.toml",
  task: "run",
};

test("a link carries a project", () => {
  expect(readLink(writeLink(shared))).toEqual({ kind: "shared", shared });
});

test("a link carries the place of a run", () => {
  const place = { ...shared, moment: 55_723, recording: "schedule 1\n" };
  expect(readLink(writeLink(place))).toEqual({ kind: "shared", shared: place });
});

test.each([0, -1, 1.5, 1e12])("the moment %d is none of a run", (moment) => {
  const read = readLink(writeLink({ ...shared, moment }));
  expect(read).toMatchObject({ kind: "broken", mistakes: [{ where: "moment" }] });
});

test("a link carries a teacher's lesson", () => {
  const read = readLink(writeLink({ ...shared, own: own as never }));
  expect(read).toMatchObject({ shared: { own: { id: "mine", text: { zh: "Do it." } } } });
});

test("a lesson with mistakes is not opened", () => {
  const read = readLink(writeLink({ ...shared, own: { ...own, task: "guess" } as never }));
  expect(read).toMatchObject({ kind: "broken", mistakes: [{ where: "own.task" }] });
});

test.each([
  ["", { kind: "none" }],
  ["#", { kind: "none" }],
  ["#lesson=first-axis", { kind: "lesson", id: "first-axis" }],
  ["#section-2", { kind: "foreign" }],
  ["#lesson=<script>", { kind: "foreign" }],
  ["#p2=abc", { kind: "newer", version: 2 }],
  ["#p1=", { kind: "broken", mistakes: [] }],
  ["#p1=%%%", { kind: "broken", mistakes: [] }],
  [`#p1=${"A".repeat(3_000_000)}`, { kind: "broken", mistakes: [] }],
])("the fragment %.20s", (fragment, read) => {
  expect(readLink(fragment)).toEqual(read);
});

test("a link that holds a gigabyte is not unpacked", () => {
  const unpack = vi.spyOn(lzString, "decompressFromEncodedURIComponent");
  const link = `#p1=${packedRun(45_000)}`;
  expect(link.length).toBeLessThan(140_000);
  expect(readLink(link)).toEqual({ kind: "broken", mistakes: [] });
  expect(unpack).not.toHaveBeenCalled();
  expect(readLink(writeLink(shared)).kind).toBe("shared");
  expect(unpack).toHaveBeenCalledOnce();
  unpack.mockRestore();
});

test("a link whose + became a space is read", () => {
  const link = writeLink({ ...shared, files: { ...shared.files, "start.c": "int a+b; ?>~" } });
  expect(readLink(link.replaceAll("+", " "))).toEqual(readLink(link));
});

test("a link that was cut off anywhere is said to be broken", () => {
  const link = writeLink(shared);
  for (let length = 4; length < link.length - 1; length += 7) {
    expect(readLink(link.slice(0, length))).toEqual({ kind: "broken", mistakes: [] });
  }
});

test.each([
  ["no files", { files: {} }, ["program", "main"]],
  ["files that are no texts", { files: { "start.c": 1, "task.toml": "" } }, ["files.start.c"]],
  [
    "a file that is too large",
    { files: { ...shared.files, "start.c": "x".repeat(70_000) } },
    ["files.start.c"],
  ],
  ["too many files", { files: Array(2000).fill("") }, [""]],
  ["a program that is not there", { program: "other.c" }, ["program"]],
  ["a name of every object", { main: "constructor" }, ["main"]],
  ["no scenario", { main: undefined }, ["main"]],
  ["another language", { language: "de" }, ["language"]],
  ["a lesson that is a list", { own: [] }, ["own"]],
])("a link with %s is broken, and says where", (_, change, places) => {
  const read = readLink(writeLink({ ...shared, ...change } as Shared));
  expect(read).toMatchObject({ kind: "broken", mistakes: places.map((where) => ({ where })) });
});
