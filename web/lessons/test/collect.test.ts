import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { collectLessons } from "@oncard/lessons/collect";
import { expect, onTestFinished, test } from "vitest";

const good = {
  "lesson.toml": `
task = "run"
title = { en = "One", zh = "一" }
hints = [{ en = "Look.", zh = "看。" }]
`,
  "text.en.md": "Text",
  "text.zh.md": "正文",
  "start.c": "int x;",
  "solution.c": "int y;",
  "task.toml": 'program = "start.c"',
};

/** A folder of lessons; `undefined` leaves out a file. */
function folderOf(lessons: Record<string, Record<string, string | undefined>>): string {
  const top = mkdtempSync(join(tmpdir(), "oncard-lessons-"));
  onTestFinished(() => {
    rmSync(top, { recursive: true });
  });
  for (const [name, files] of Object.entries(lessons)) {
    mkdirSync(join(top, name));
    for (const [file, text] of Object.entries(files)) {
      if (text !== undefined) writeFileSync(join(top, name, file), text);
    }
  }
  return top;
}

test("a folder with a number is a lesson", () => {
  const folder = folderOf({ "07-one": good, other: {} });
  expect(collectLessons(folder)).toEqual([
    {
      folder: join(folder, "07-one"),
      solution: "int y;",
      lesson: {
        version: 1,
        id: "one",
        title: { en: "One", zh: "一" },
        text: { en: "Text", zh: "正文" },
        hints: [{ en: "Look.", zh: "看。" }],
        files: { "start.c": "int x;", "task.toml": 'program = "start.c"' },
        program: "start.c",
        main: "task.toml",
        task: "run",
      },
    },
  ]);
});

test("lessons have the order of their numbers", () => {
  const lessons = collectLessons(folderOf({ "10-b": good, "02-c": good, "03-a": good }));
  expect(lessons.map(({ lesson }) => lesson.id)).toEqual(["c", "a", "b"]);
});

test("a scenario that the student does not see is part of a lesson", () => {
  const hidden = 'program = "start.c"\nexpect = []\n';
  const folder = folderOf({ "01-a": good, "02-b": { ...good, "hidden.toml": hidden } });
  const lessons = collectLessons(folder);
  expect(lessons.map(({ lesson }) => lesson.hidden)).toEqual([undefined, [hidden]]);
});

test("a mistake names the folder and the place", () => {
  const lesson = { ...good, "lesson.toml": 'task = "run"\ntitle = { en = 1 }\nhints = []' };
  const folder = folderOf({ "01-bad": lesson });
  expect(() => collectLessons(folder)).toThrow(/01-bad: title\.en: expected a text$/);
});

test("a layout that does not exist is named", () => {
  const withLayout = (name: string) => {
    const lesson = { ...good, "lesson.toml": `layout = "${name}"\n${good["lesson.toml"]}` };
    return collectLessons(folderOf({ "01-one": lesson }))[0]?.lesson.layout;
  };
  expect(withLayout("threads")).toBe("threads");
  expect(() => withLayout("thread")).toThrow(
    /01-one: layout: there is no layout 'thread'; expected language, threads, motion$/,
  );
});

test("a missing file is named", () => {
  const folder = folderOf({ "01-bad": { ...good, "solution.c": undefined } });
  expect(() => collectLessons(folder)).toThrow(/01-bad\/solution\.c/);
});
