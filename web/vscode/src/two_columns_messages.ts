// What the panel with C beside card code and the extension say to each other.

import type { Language } from "@oncard/engine";
import type { Shown } from "@oncard/playground/two_columns/shown";

/** A line of C. */
export interface Place {
  file: string;
  line: number;
}

/** What is missing stays as it is. */
export interface ToView {
  shown?: Shown;
  language?: Language;
  /** Where the cursor is. */
  chosen?: Place;
}

/**
 * The view is there, somebody wants to see a line of C, or the pointer is at what a line became (null:
 * no longer).
 */
export type FromView = "ready" | { show: Place } | { point: Place | null };
