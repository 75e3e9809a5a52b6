// Which panels lie below each other beside the lesson, for the layout that a lesson names.
// Tested by test/arrangement.test.ts.

import type { LessonLayout } from "@oncard/lessons";

import type { Panel } from "./layout.js";

export interface Arrangement {
  middle: readonly Panel[];
  right: readonly Panel[];
}

const usual: Arrangement = {
  middle: ["program", "values"],
  right: ["machine", "timeline", "scope"],
};

const arrangements: Record<LessonLayout, Arrangement> = {
  language: { middle: ["program"], right: ["values", "timeline", "machine", "scope"] },
  threads: { ...usual, right: ["timeline", "machine", "scope"] },
  motion: { ...usual, right: ["machine", "scope", "timeline"] },
};

/** Without a layout the usual one. A failing run is what one looks at, whatever the layout. */
export function arrangementFor(layout: LessonLayout | undefined, failing: boolean): Arrangement {
  if (failing) return { ...usual, right: ["interleaving", "timeline", "machine", "scope"] };
  return layout ? arrangements[layout] : usual;
}
