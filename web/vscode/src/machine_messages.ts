// What the panel with the machine and the extension say to each other.

import type { Card, Language } from "@oncard/engine";
import type { Place } from "@oncard/playground/machine/axes";
import type { Seen } from "@oncard/playground/machine/seen";

/** What is missing stays as it is. */
export interface ToView {
  /** Null: nothing is debugged. */
  machine?: MachineNow | null;
  language?: Language;
  /** What is said where there is no machine. */
  idle?: string;
}

export interface MachineNow {
  card: Card;
  seen: Seen;
  /** Of the axes that can be a table. */
  way: Place[];
}

/** The view is there, or somebody switches an input; pins count from 1. */
export type FromView = "ready" | { word: string; pin: number; level: number };
