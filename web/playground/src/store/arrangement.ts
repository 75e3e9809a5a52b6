// Which panels lie below each other in the columns of the page, for the layout that a lesson names.
// Tested by test/arrangement.test.ts.

import type { LessonLayout } from "@oncard/lessons";

import type { Panel } from "./layout.js";

export const columns = ["left", "middle", "right"] as const;
export type ColumnName = (typeof columns)[number];

export type Arrangement = Record<ColumnName, readonly Panel[]>;

const usual: Arrangement = {
  left: ["lesson"],
  middle: ["program", "values"],
  right: ["machine", "timeline", "scope"],
};

const arrangements: Record<LessonLayout, Arrangement> = {
  language: { ...usual, middle: ["program"], right: ["values", "timeline", "machine", "scope"] },
  threads: { ...usual, right: ["timeline", "machine", "scope"] },
  motion: { ...usual, right: ["machine", "scope", "timeline"] },
};

/** Without a layout the usual one. A failing run is what one looks at, whatever the layout. */
export function arrangementFor(layout: LessonLayout | undefined, failing: boolean): Arrangement {
  if (failing) return { ...usual, right: ["interleaving", "timeline", "machine", "scope"] };
  return layout ? arrangements[layout] : usual;
}
