// The machine at the present moment: its axes, and what has been seen of the run.

import type { Card } from "@oncard/engine";
import { computed, effect, signal } from "@preact/signals";

import { present } from "../session/bench.js";
import { record } from "../session/record.js";
import { source } from "../store/source.js";
import { axesNamed, type AxisView } from "./axes.js";
import { axesShown, type Seen, seenOf } from "./seen.js";

export interface MachineNow {
  card: Card;
  seen: Seen;
  axes: readonly AxisView[];
}

/** Since the program was loaded. */
const seen = signal<Seen | undefined>(undefined);

effect(() => {
  const { value: card } = present.card;
  if (!card) return;
  const isStart = present.state.peek()?.head === 0;
  seen.value = seenOf(card, isStart ? undefined : seen.peek());
});

/** Those that the lesson speaks of. */
const named = computed(() => (record.value ? [] : axesNamed(source.lesson.value.scope ?? [])));

/** Nothing without a program on the card. */
export const machine = computed<MachineNow | undefined>(() => {
  const { value: card } = present.card;
  if (!card) return undefined;
  const now = seen.value ?? seenOf(card);
  return { card, seen: now, axes: axesShown(card, now, named.value) };
});
