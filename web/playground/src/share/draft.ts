// A lesson that a teacher writes: what the form has, and the lesson that it becomes.
// Tested by test/draft.test.ts.

import type { Language } from "@oncard/engine";
import { type Lesson, type ParsedLesson, parseLesson } from "@oncard/lessons";

import type { Files } from "../store/shelf.js";

export interface Draft {
  id: string;
  title: string;
  text: string;
  hints: string[];
  task: Lesson["task"];
}

export const emptyDraft: Draft = { id: "my-lesson", title: "", text: "", hints: [], task: "run" };

/** The project from which the student starts, with the scenario of the task. */
export interface Start {
  files: Files;
  program: string;
  main: string;
  structured?: boolean | undefined;
}

/** Hints without text are left out. */
export function lessonOf(draft: Draft, start: Start, language: Language): ParsedLesson {
  const said = (text: string) => ({ [language]: text });
  const { files, program, main, structured } = start;
  return parseLesson({
    version: 1,
    id: draft.id,
    title: said(draft.title),
    text: said(draft.text),
    hints: draft.hints.filter((hint) => hint.trim() !== "").map(said),
    ...{ files, program, main, task: draft.task },
    ...(structured ? { structured } : {}),
  });
}

/** Reads what the browser has kept; anything else is an empty draft. */
export function readDraft(value: unknown): Draft {
  if (typeof value !== "object" || value === null) return emptyDraft;
  const { id, title, text, hints, task } = value as Record<string, unknown>;
  const textOr = (given: unknown, otherwise: string) =>
    typeof given === "string" ? given : otherwise;
  return {
    id: textOr(id, emptyDraft.id),
    title: textOr(title, ""),
    text: textOr(text, ""),
    hints: Array.isArray(hints) ? hints.filter((hint) => typeof hint === "string") : [],
    task: task === "explore" ? task : "run",
  };
}
