import { effect } from "@preact/signals";
import { afterEach, expect, test, vi } from "vitest";

import { offerLessons } from "../src/store/lessons.js";
import { ownProgram } from "../src/store/own_program.js";
import {
  copyProgram,
  edit,
  lastLesson,
  openLesson,
  openLessonWith,
  openProgram,
  openSample,
  removeProgram,
  resetProgram,
  showFile,
  source,
  takeFromElsewhere,
} from "../src/store/source.js";
import { stubStorage } from "./storage.js";

const lesson = {
  ...ownProgram,
  id: "first",
  files: { "a.c": "start", "a.toml": "task" },
  program: "a.c",
  main: "a.toml",
};

afterEach(() => {
  vi.unstubAllGlobals();
});

test("a lesson is opened with its start, and is the last one", () => {
  stubStorage();
  openLesson(lesson);
  expect(source.lesson.value).toBe(lesson);
  expect(source.file.value).toBe("a.c");
  expect(source.project.value).toEqual({ main: "a.toml", files: lesson.files, structured: false });
  expect(lastLesson()).toBe("first");
});

test("an edit is in the project, and is kept for its lesson", () => {
  const storage = stubStorage();
  openLesson(lesson);
  edit("a.c", "edited");
  expect(source.project.value.files).toEqual({ "a.c": "edited", "a.toml": "task" });
  openLesson(ownProgram);
  openLesson(lesson);
  expect(source.files.value["a.c"]).toBe("edited");
  expect([...storage.keys()]).toContain("oncard.shelf.first");
});

test("the project is another object after an edit, and only then", () => {
  stubStorage();
  openLesson(lesson);
  const before = source.project.value;
  edit("a.c", "start");
  showFile("a.toml");
  expect(source.project.value).toBe(before);
  edit("a.c", "edited");
  expect(source.project.value).not.toBe(before);
});

test("what is typed is not shown anew, what is opened is", () => {
  stubStorage();
  openLesson(lesson);
  const before = source.opened.value;
  edit("a.c", "edited");
  expect(source.opened.value).toBe(before);
  resetProgram();
  expect(source.opened.value).toBe(before + 1);
});

test("programs are added, opened and removed; a reset keeps what was written", () => {
  stubStorage();
  openLesson(lesson);
  edit("a.c", "mine");
  copyProgram();
  edit("a.c", "copy");
  resetProgram();
  expect(source.shelf.value.programs.map((files) => files["a.c"])).toEqual([
    ...["mine", "copy", "start"],
  ]);
  openProgram(1);
  expect(source.files.value["a.c"]).toBe("copy");
  removeProgram();
  expect(source.files.value["a.c"]).toBe("mine");
  expect(source.shelf.value.programs).toHaveLength(2);
});

test("a program of somebody else's stands beside what is there", () => {
  stubStorage({ "shelf.first": { open: 0, programs: [{ "a.c": "mine", "a.toml": "task" }] } });
  openLessonWith(lesson, { "a.c": "theirs", "a.toml": "task" });
  expect(source.shelf.value).toEqual({
    open: 1,
    programs: [
      { "a.c": "mine", "a.toml": "task" },
      { "a.c": "theirs", "a.toml": "task" },
    ],
  });
});

test("a file that the opened program lacks is not shown", () => {
  stubStorage();
  openLesson(lesson);
  showFile("a.toml");
  openProgram(0);
  expect(source.file.value).toBe("a.toml");
  openLessonWith(lesson, { "a.c": "theirs" });
  showFile("a.toml");
  openProgram(1);
  expect(source.file.value).toBe("a.c");
});

test("whoever follows a lesson and its files sees both at once", () => {
  stubStorage();
  openLesson(ownProgram);
  const seen: boolean[] = [];
  const stop = effect(() => {
    seen.push(Object.hasOwn(source.files.value, source.lesson.value.program));
  });
  openLesson(lesson);
  stop();
  expect(seen).toEqual([true, true]);
});

test("what another tab edits comes beside the open program", () => {
  stubStorage();
  openLesson(lesson);
  edit("a.c", "mine");
  const before = source.project.value;
  expect(source.isElsewhere.value).toBe(false);
  const theirs = { "a.c": "theirs", "a.toml": "task" };
  takeFromElsewhere("shelf.first", { open: 0, programs: [theirs] });
  expect(source.isElsewhere.value).toBe(true);
  expect(source.shelf.value).toEqual({
    open: 1,
    programs: [theirs, { "a.c": "mine", "a.toml": "task" }],
  });
  // What is on the card was not edited.
  expect(source.project.value).toBe(before);
  edit("a.c", "mine, too");
  openLesson(ownProgram);
  expect(source.isElsewhere.value).toBe(false);
  openLesson(lesson);
  expect(source.shelf.value.programs.map((files) => files["a.c"])).toEqual(["theirs", "mine, too"]);
});

test("another tab with the same text, another lesson or nonsense changes nothing", () => {
  stubStorage();
  openLesson(lesson);
  const { value: shelf } = source.shelf;
  takeFromElsewhere("shelf.other", { open: 0, programs: [{ "a.c": "theirs" }] });
  takeFromElsewhere("shelf.first", { open: "x" });
  takeFromElsewhere("shelf.first", undefined);
  expect(source.shelf.value).toBe(shelf);
  takeFromElsewhere("shelf.first", shelf);
  expect(source.shelf.value).toEqual(shelf);
  expect(source.isElsewhere.value).toBe(false);
});

test("a sample becomes a program of one's own, with its words and channels", () => {
  stubStorage();
  const files = { "gear.c": "int main() {}", "gear.toml": 'program = "gear.c"' };
  const gear = { ...lesson, id: "gear", files, program: "gear.c", main: "gear.toml" };
  const title = { en: "Gear", zh: "齿轮" };
  offerLessons([], [{ ...gear, title, scope: ["axis2.prfVel"] }]);
  openSample(gear);
  expect(lastLesson()).toBe("own");
  expect(source.lesson.value).toMatchObject({ id: "own", title, scope: ["axis2.prfVel"] });
  expect(source.project.value).toEqual({ main: "gear.toml", files, structured: false });
  edit("gear.c", "int x;");
  openProgram(0);
  expect(source.lesson.value).toBe(ownProgram);
  openProgram(1);
  expect(source.lesson.value.title).toEqual(title);
  offerLessons([]);
});

test("a program of one's own brings the names of its files, also when it is opened again", () => {
  stubStorage();
  const files = { "star.c": "int main() {}", "star.toml": 'program = "star.c"' };
  openLessonWith({ ...ownProgram, program: "star.c", main: "star.toml" }, files);
  expect(source.project.value.main).toBe("star.toml");
  expect(source.file.value).toBe("star.c");
  openLesson(ownProgram);
  expect(source.project.value).toEqual({ main: "star.toml", files, structured: false });
  expect(source.file.value).toBe("star.c");
  resetProgram();
  expect(source.lesson.value).toBe(ownProgram);
  expect(source.file.value).toBe("program.c");
  openProgram(1);
  expect(source.lesson.value.program).toBe("star.c");
});
