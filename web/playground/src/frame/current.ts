// The layout of the page: what the open lesson names, or that of a failing run; which columns of it are
// closed, and the panel that fills it.

import { layoutOf } from "@oncard/lessons";
import { computed, effect } from "@preact/signals";

import { failingRun } from "../interleaving/failing_run.js";
import { isOpening } from "../lesson/opening.js";
import { record } from "../session/record.js";
import { arrangementFor, columns } from "../store/arrangement.js";
import { layout } from "../store/layout.js";
import { closedIn, fillWith, placesOf, type WholePanel } from "../store/places.js";
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
  failingRun.value ? "failing" : (namedLayout.value ?? "usual"),
);

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

/** Who wants to see the warnings sees them, whatever fills the page. */
export function followWishes(): void {
  effect(() => {
    if (layout.listWishes.value === 0) return;
    const whole = wholePanel.peek();
    if (whole !== undefined && whole !== "values") fillPage(undefined);
  });
}
