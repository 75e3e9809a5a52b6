// The opening: the sample that a first visit sees. It runs by itself as long as its text is as it came.

import { computed } from "@preact/signals";

import { bench } from "../session/bench.js";
import { lessons } from "../store/lessons.js";
import { sameFiles } from "../store/shelf.js";
import { source } from "../store/source.js";

export const isOpening = computed(() => source.lesson.value.id === lessons.opening.value?.id);

/** Whoever wants no motion sees where it ends. */
export function wantsStill(): boolean {
  return matchMedia("(prefers-reduced-motion: reduce)").matches;
}

/** What was opened is on the card: the opening begins. */
export function beginOpening(): void {
  const { files } = source.lesson.peek();
  if (!isOpening.peek() || !sameFiles(source.files.peek(), files)) return;
  void (wantsStill() ? bench.runToEnd() : bench.run());
}
