// The request that only oncard-full.wasm answers, as web/README.md describes it; the others are in
// protocol.ts.

import type { Compiled, Language, Project } from "./protocol.js";

/** A value that a statement read. */
export interface ValueRead {
  name: string;
  value: string;
  /** Of a global variable. */
  shared: boolean;
}

/** A value that a statement wrote, or what passes of a loop made of it together. */
export interface ValueWritten {
  name: string;
  before: string;
  after: string;
  /** Of a global variable. */
  shared: boolean;
}

/** A row of a failing run. */
export type InterleavingRow =
  | {
      kind: "step";
      step: number;
      last: number;
      thread: number;
      line: number;
      statement?: string;
      reads?: ValueRead[];
      writes?: ValueWritten[];
      /** After it every continuation fails. */
      fatal?: true;
    }
  /** Passes of a loop; without a thread, several take turns in it. */
  | {
      kind: "repeat";
      step: number;
      last: number;
      thread?: number;
      statement: string;
      writes?: ValueWritten[];
    }
  /** Statements that touch nothing shared. */
  | { kind: "gap"; step: number; last: number; thread: number }
  | { kind: "time"; ms: number }
  | { kind: "host"; ms: number; statement: string };

/** One of the two orders of a data race, up to its end. */
export interface RaceOrder {
  /** The thread whose statement is first. */
  first: number;
  /** The steps of the two statements. */
  racing: [number, number];
  /** The final values that differ from those of the other order. */
  end: string;
  rows: InterleavingRow[];
}

/** A failing run as a table with a column for each thread. Steps are numbered from 1. */
export interface Interleaving {
  /** What does not hold. */
  reason: string;
  /** The values that are wrong: `parts is 12, expected 15`. */
  actual?: string;
  /** Of a scenario that leaves something open. */
  choice?: string;
  /** The step that caused it, in a sentence. */
  culprit?: string;
  threads: { thread: number; function: string }[];
  /** Statements of the run before step 1. */
  skipped: number;
  rows: InterleavingRow[];
  /** What then repeats for ever. */
  cycle?: InterleavingRow[];
  /** A thread has used in step `use` what it read in step `read`, though another wrote it in step `write`. */
  stale?: {
    kind: "overwrites" | "computes" | "decides";
    name: string;
    value: string;
    changed: string;
    read: number;
    write: number;
    use: number;
  };
  /** Of a data race without time: first the order that was found. */
  orders?: RaceOrder[];
}

export interface ExploreAnswer extends Compiled {
  /** What `oncard explore --format=json` prints; missing if the program was not compiled. */
  report?: {
    verdict: "PROVED" | "PASSED" | "FAILED" | "INCOMPLETE";
    /** Of a failure in a scenario that leaves something open. */
    choice?: string;
    culprit?: string;
  };
  /** The verdict that the scenario expects under `explore`; missing if it has no such key. */
  expected?: "PROVED" | "PASSED" | "FAILED" | "INCOMPLETE";
  /** The report for people. */
  text?: string;
  /** If something fails: the run, in the language of the request. */
  interleaving?: Interleaving;
  /** If something fails: a schedule file beside `main` that repeats it. */
  schedule?: string;
}

export interface ExploreRequest {
  arguments: Project & { language?: Language };
  result: ExploreAnswer;
}
