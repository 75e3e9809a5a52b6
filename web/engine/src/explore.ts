// The request that only oncard-full.wasm answers, as web/README.md describes it; the others are in
// protocol.ts.

import type { Compiled, Language, Project } from "./protocol.js";

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
  /** If something fails: a schedule file beside `main` that repeats it. */
  schedule?: string;
}

export interface ExploreRequest {
  arguments: Project & { language?: Language };
  result: ExploreAnswer;
}
