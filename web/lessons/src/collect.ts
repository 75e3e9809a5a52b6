// The lessons of a folder, for bundlers and tests. Each has a folder NN-name, whose number is its
// place in the order:
//
//   lesson.toml               title, hints, task and, where it applies, structured, scope and layout
//   text.en.md, text.zh.md    the text
//   start.c, solution.c       the program as the student finds it, and one that passes
//   task.toml                 the scenario of the task, with program = "start.c"
//   hidden.toml               if there is one: a scenario with other inputs, for the check alone
//
// Tested by test/collect.test.ts.

import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

import { parse } from "smol-toml";

import { layoutOf, layouts, type Lesson, parseLesson } from "./lesson.js";

export interface CollectedLesson {
  /** Its folder. */
  folder: string;
  lesson: Lesson;
  /** A program that passes. It is not part of the lesson. */
  solution: string;
}

/** The lessons of this project. */
export const lessonsFolder = fileURLToPath(new URL("../lessons", import.meta.url));

/**
 * Reads the lessons of a folder in their order.
 * @throws {Error} a file is missing, or a lesson has a mistake; the message names both
 */
export function collectLessons(folder = lessonsFolder): CollectedLesson[] {
  return readdirSync(folder)
    .filter((name) => /^\d\d-/.test(name))
    .sort()
    .map((name) => collectLesson(join(folder, name), name.slice(3)));
}

function collectLesson(folder: string, id: string): CollectedLesson {
  const read = (name: string) => readFileSync(join(folder, name), "utf8");
  const value = {
    ...parse(read("lesson.toml")),
    version: 1,
    id,
    text: { en: read("text.en.md"), zh: read("text.zh.md") },
    files: { "start.c": read("start.c"), "task.toml": read("task.toml") },
    program: "start.c",
    main: "task.toml",
    ...(existsSync(join(folder, "hidden.toml")) ? { hidden: [read("hidden.toml")] } : {}),
  };
  return { folder, lesson: readLesson(value, folder), solution: read("solution.c") };
}

/** @throws {Error} the lesson has a mistake; the message begins with the place */
export function readLesson(value: unknown, place: string): Lesson {
  const parsed = parseLesson(value);
  if ("lesson" in parsed) {
    const { layout } = parsed.lesson;
    if (layout === undefined || layoutOf(parsed.lesson)) return parsed.lesson;
    throw new Error(
      `${place}: layout: there is no layout '${layout}'; expected ${layouts.join(", ")}`,
    );
  }
  const mistakes = parsed.mistakes.map(({ where, message }) => `${where}: ${message.en}`);
  throw new Error(`${place}: ${mistakes.join("; ")}`);
}
