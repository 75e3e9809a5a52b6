// The layout of the page: what the open lesson names, or that of a failing run; which columns of it are
// closed, and the panel that fills it.

import { type Lesson, layoutOf } from "@oncard/lessons";
import { computed, effect, untracked } from "@preact/signals";

import { failingRun } from "../interleaving/failing_run.js";
import { isOpening } from "../lesson/opening.js";
import { record } from "../session/record.js";
import { arrangementFor, columns } from "../store/arrangement.js";
import { layout, type Panel } from "../store/layout.js";
import { isFree, ownProgram } from "../store/own_program.js";
import { closedIn, fillWith, openColumn, placesOf, type WholePanel } from "../store/places.js";
import { source } from "../store/source.js";

/** What the lesson names; the card of a host's record is not what the lesson is about. */
export const namedLayout = computed(() =>
  record.value ? undefined : layoutOf(source.lesson.value),
);

/** The panels of each column. */
export const arrangement = computed(() =>
  arrangementFor(namedLayout.value, failingRun.value !== undefined),
);

/** By this name its places are kept. */
export const layoutName = computed(() =>
  failingRun.value ? "failing" : (namedLayout.value ?? unnamed(source.lesson.value)),
);

function unnamed(lesson: Lesson): string {
  return isFree(lesson) ? "free" : "usual";
}

/** The panel that fills the page, if one does; the opening shows all that it has. */
export const wholePanel = computed(() =>
  isOpening.value ? undefined : placesOf(layoutName.value).whole,
);

/** The columns that are rails. */
export const closedColumns = computed(() =>
  isOpening.value || wholePanel.value ? [] : closedIn(layoutName.value),
);

/** Whether another column can be closed: one stays open. */
export const canClose = computed(
  () => !isOpening.value && !wholePanel.value && closedColumns.value.length < columns.length - 1,
);

/** Lets a panel fill the page; undefined: all are shown again. */
export function fillPage(panel: WholePanel | undefined): void {
  fillWith(layoutName.peek(), panel);
}

/** Opens the column of a panel. */
export function openColumnOf(panel: Panel): void {
  const column = columns.find((each) => arrangement.peek()[each].includes(panel));
  if (column) openColumn(layoutName.peek(), column);
}

/** Shows a panel, whatever is closed or fills the page. */
export function reveal(panel: Panel): void {
  untracked(() => {
    const { value: whole } = wholePanel;
    if (whole !== undefined && whole !== panel) fillPage(undefined);
    openColumnOf(panel);
  });
}

/** Who wants to see the warnings or a line of the program sees them. */
export function followWishes(): void {
  effect(() => {
    if (layout.listWishes.value > 0) reveal("values");
  });
  effect(() => {
    if (layout.wishedLine.value) reveal("program");
  });
}

/**
 * Who opens a lesson sees its guide.
 * @param last the lesson that was open when the page was left: it comes back as it was
 */
export function followLessons(last: unknown): void {
  let open = last;
  effect(() => {
    const lesson = source.lesson.value;
    const isOpened = lesson.id !== open && lesson.id !== ownProgram.id;
    open = lesson.id;
    // A failing run goes with the lesson that was open, and its layout, too.
    const name = layoutOf(lesson) ?? unnamed(lesson);
    if (isOpened) {
      untracked(() => {
        openColumn(name, "left");
      });
    }
  });
}
