// What the panel with a failing run and the extension say to each other.

import type { Interleaving, Language } from "@oncard/engine";

/** What is missing stays as it is. */
export interface ToView {
  run?: Interleaving;
  language?: Language;
  /** The step that the debugger has executed last; null if it does not follow this run. */
  now?: number | null;
}

/** The view is there, or somebody wants to be after a step. */
export type FromView = "ready" | { step: number };
