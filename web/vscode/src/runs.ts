// Running and exploring a program or a scenario, as text: for commands, tasks and tests.
// Tested by test/runs.test.ts.

import type { Diagnostic, Engine, ExploreAnswer, Interleaving, RunAnswer } from "@oncard/engine";
import { RefusedError } from "@oncard/engine";

import { say } from "./texts";

/** A diagnostic as `oncard check` prints its first line. */
export function headline({
  file,
  line,
  column,
  severity,
  code,
  message,
  slug,
}: Diagnostic): string {
  return `${file}:${line}:${column}: ${severity} ${code}: ${message} [${slug}]`;
}

/** What an engine says, and whether all is well. */
export interface Outcome {
  passed: boolean;
  lines: string[];
  /** A schedule file that repeats a failure of an exploration. */
  schedule?: string;
  /** That failure as a table. */
  interleaving?: Interleaving;
}

export async function checked(engine: Engine, main: string): Promise<Outcome> {
  return outcomeOf(async () => {
    const { compiled, diagnostics } = await engine.check({ main });
    return { passed: compiled, lines: diagnostics.map(headline) };
  });
}

export async function ran(engine: Engine, main: string): Promise<Outcome> {
  return outcomeOf(async () => described(await engine.run({ main })));
}

/** The lines of a run: which case it was, what does not hold, and the values at the end. */
export function described({ diagnostics, run }: RunAnswer): Outcome {
  const lines = diagnostics.map(headline);
  if (!run) return { passed: false, lines };
  if (run.choice !== undefined) lines.push(choiceLine(run.choice));
  lines.push(...run.warnings);
  for (const { expectation, message } of run.failures) {
    lines.push(expectation ? `${expectation}: ${message}` : message);
  }
  for (const [name, value] of Object.entries(run.values)) {
    lines.push(`${name} = ${Array.isArray(value) ? `[${value.join(", ")}]` : value}`);
  }
  lines.push(run.passed ? say({ en: "passed", zh: "通过" }) : say({ en: "failed", zh: "未通过" }));
  return { passed: run.passed, lines };
}

/** Which case of a scenario was run. */
export function choiceLine(choice: string): string {
  return say({ en: `choice: ${choice}`, zh: `选择：${choice}` });
}

export async function explored(
  engine: Engine,
  main: string,
  language: "en" | "zh",
): Promise<Outcome> {
  return outcomeOf(async () => outcomeOfSearch(await engine.explore({ main }, language)));
}

function outcomeOfSearch(answer: ExploreAnswer): Outcome {
  const { diagnostics, report, text, schedule, interleaving } = answer;
  const passed = report?.verdict === "PROVED" || report?.verdict === "PASSED";
  const lines = diagnostics.map(headline);
  if (text !== undefined) lines.push(...text.trimEnd().split("\n"));
  const failing = {
    ...(schedule !== undefined && { schedule }),
    ...(interleaving && { interleaving }),
  };
  return { passed, lines, ...failing };
}

/** What the engine refuses is a text for the user, too. */
async function outcomeOf(work: () => Promise<Outcome>): Promise<Outcome> {
  try {
    return await work();
  } catch (error) {
    if (!(error instanceof RefusedError)) throw error;
    return { passed: false, lines: error.message.split("\n") };
  }
}
