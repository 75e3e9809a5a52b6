// A lesson that a teacher writes: what the form has, and the lesson that it becomes.
// Tested by test/draft.test.ts.

import type { Language } from "@oncard/engine";
import { type ParsedLesson, parseLesson } from "@oncard/lessons";

import { isKeptDraft, type KeptDraft } from "../store/kept_schema.js";
import { salvaged } from "../store/salvaged.js";
import type { Files } from "../store/shelf.js";

export type Draft = Required<KeptDraft>;

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

/** Reads what the browser has kept. What is missing is that of an empty draft. */
export function readDraft(value: unknown): Draft {
  return { ...emptyDraft, ...salvaged(isKeptDraft, value) };
}
