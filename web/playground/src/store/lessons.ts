// The lessons that there are, and how far the reader is with them.
// Tested by test/lessons.test.ts.

import { type Lesson, parseLesson } from "@oncard/lessons";
import { computed } from "@preact/signals";

import { keep, kept } from "./keep.js";
import { isLinkedLessons, isOpenHints, isSolvedLessons } from "./kept_schema.js";
import { ownProgram } from "./own_program.js";
import { salvaged } from "./salvaged.js";
import { slice } from "./slice.js";

interface Lessons {
  /** Those of the page. */
  offered: Lesson[];
  /** Programs that show something. */
  samples: Lesson[];
  /** Those of teachers that came in links. */
  linked: Lesson[];
  solved: ReadonlySet<string>;
  /** How many hints of a lesson are open. */
  openHints: Record<string, number>;
}

const [state, change] = slice<Lessons>({
  offered: [],
  samples: [],
  linked: [],
  solved: new Set(),
  openHints: {},
});

const opening = computed(() => state.samples.value[0]);
/** Those that teach, in their order. */
const listed = computed(() => [...state.offered.value, ...state.linked.value]);

export const lessons = {
  ...state,
  /** The sample that a first visit sees. */
  opening,
  listed,
  /** With the place for programs of the reader's own, and the opening. */
  all: computed(() => [ownProgram, ...(opening.value ? [opening.value] : []), ...listed.value]),
};

/** Takes what the page offers, and what was kept of other lessons and of the progress. */
export function offerLessons(offered: Lesson[], samples: Lesson[] = []): void {
  change({
    offered,
    samples,
    linked: readLinked(salvaged(isLinkedLessons, kept("linked")) ?? []),
    solved: new Set(salvaged(isSolvedLessons, kept("solved"))),
    openHints: salvaged(isOpenHints, kept("hints")) ?? {},
  });
}

function readLinked(values: unknown[]): Lesson[] {
  return values.flatMap((value) => {
    const parsed = parseLesson(value);
    return "lesson" in parsed ? [parsed.lesson] : [];
  });
}

export function lessonNamed(id: unknown): Lesson | undefined {
  return lessons.all.peek().find((each) => each.id === id);
}

/** A lesson of a link; it replaces one with the same name that came before. */
export function addLinked(lesson: Lesson): void {
  const others = lessons.linked.peek().filter(({ id }) => id !== lesson.id);
  change({ linked: [...others, lesson] });
  keep("linked", lessons.linked.peek());
}

export function markSolved(id: string): void {
  change({ solved: new Set([...lessons.solved.peek(), id]) });
  keep("solved", [...lessons.solved.peek()]);
}

/** Opens the first hints of a lesson. */
export function openHints(id: string, count: number): void {
  change({ openHints: { ...lessons.openHints.peek(), [id]: count } });
  keep("hints", lessons.openHints.peek());
}

/** Another tab has kept this: what was solved there is solved here, too. */
export function takeProgress(key: string, value: unknown): void {
  if (key === "solved") {
    const theirs = salvaged(isSolvedLessons, value) ?? [];
    change({ solved: new Set([...lessons.solved.peek(), ...theirs]) });
  }
  if (key === "linked") change({ linked: readLinked(salvaged(isLinkedLessons, value) ?? []) });
}
