// What a lesson is, and how one is read from JSON. A link can carry a lesson of a teacher's own, so
// nothing that comes in is trusted: lesson.schema.json says what it may be. Runs in pages and in Node.
// Tested by test/lesson.test.ts.

import { checked, type Localized, type Mistake } from "./checked.js";
import { isLessonSource, type LessonSource } from "./lesson_schema.js";

export { type Checked, checked, type Localized, type Mistake } from "./checked.js";

/** How the panels of the page can lie for a lesson. */
export const layouts = ["language", "threads", "motion"] as const;
export type LessonLayout = (typeof layouts)[number];

/** One idea, with a task that a scenario checks. Every text is in both languages. */
export interface Lesson extends Omit<LessonSource, "title" | "text" | "hints"> {
  title: Localized;
  text: Localized;
  hints: Localized[];
}

export type ParsedLesson = { lesson: Lesson } | { mistakes: Mistake[] };

/**
 * Reads a lesson from a value of JSON. A text may be given in one language only; it then stands for
 * both. All mistakes are reported at once, up to a limit.
 */
export function parseLesson(value: unknown): ParsedLesson {
  const source = checked(isLessonSource, value);
  if ("mistakes" in source) return source;
  const mistakes = missingFiles(source.value);
  return mistakes.length > 0 ? { mistakes } : { lesson: lessonOf(source.value) };
}

/** The layout that a lesson names; undefined: the usual one, also for a name that is not known. */
export function layoutOf({ layout }: Pick<Lesson, "layout">): LessonLayout | undefined {
  return layouts.find((name) => name === layout);
}

/** Whether program and scenario are among the files: no schema can say so. */
export function missingFiles(project: Pick<Lesson, "files" | "program" | "main">): Mistake[] {
  return (["program", "main"] as const).flatMap((where) => {
    const name = project[where];
    if (Object.hasOwn(project.files, name)) return [];
    const message = { en: `there is no '${name}' in 'files'`, zh: `files 中没有“${name}”` };
    return [{ where, message }];
  });
}

function lessonOf(source: LessonSource): Lesson {
  const { title, text, hints } = source;
  return {
    ...source,
    title: inBoth(title),
    text: inBoth(text),
    hints: hints.map(inBoth),
  };
}

function inBoth({ en, zh }: LessonSource["title"]): Localized {
  return { en: en ?? zh ?? "", zh: zh ?? en ?? "" };
}
