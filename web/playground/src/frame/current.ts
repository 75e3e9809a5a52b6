// The layout of the page: what the open lesson names, or that of a failing run.

import { layoutOf } from "@oncard/lessons";
import { computed } from "@preact/signals";

import { failingRun } from "../interleaving/failing_run.js";
import { record } from "../session/record.js";
import { source } from "../store/source.js";

/** What the lesson names; the card of a host's record is not what the lesson is about. */
export const namedLayout = computed(() =>
  record.value ? undefined : layoutOf(source.lesson.value),
);

/** By this name its widths are kept. */
export const layoutName = computed(() =>
  failingRun.value ? "failing" : (namedLayout.value ?? "usual"),
);
