// Whether the open program solves its task, and what an exploration finds. Both run in an engine of
// their own, so that the session stays alive, and ending it stops them.

import type { Engine, ExploreAnswer, RunAnswer } from "@oncard/engine";
import { RefusedError } from "@oncard/engine";
import { computed, signal } from "@preact/signals";

import { startModule } from "../session/engines.js";
import { keep, kept } from "../store/keep.js";
import { isSolvedLessons } from "../store/kept_schema.js";
import { salvaged } from "../store/salvaged.js";
import { language } from "../store/settings.js";
import { bench, lesson, project } from "../workspace.js";

/** What a check says. */
export type Verdict =
  | { kind: "none" }
  | { kind: "busy"; what: "check" | "explore" }
  | { kind: "stopped" }
  | { kind: "not-compiled" }
  | { kind: "refused"; message: string }
  | { kind: "run"; run: NonNullable<RunAnswer["run"]> }
  | { kind: "explored"; exploration: ExploreAnswer; isCheck: boolean };

export const verdict = signal<Verdict>({ kind: "none" });

/** The lessons that are solved. */
export const solved = signal<ReadonlySet<string>>(
  new Set(salvaged(isSolvedLessons, kept("solved"))),
);

/** Whether the verdict says that the task is solved. */
export const isSolvedNow = computed(() => {
  const { value } = verdict;
  if (value.kind === "run") return value.run.passed;
  return value.kind === "explored" && value.exploration.report?.verdict === "PROVED";
});

let engine: Promise<Engine> | undefined;
let asked = 0;

async function prover(): Promise<Engine> {
  engine ??= startModule();
  const started = await engine;
  started.onEnded = () => {
    engine = undefined;
  };
  await started.hello(language.value);
  return started;
}

async function judged(
  what: "check" | "explore",
  judge: (engine: Engine) => Promise<Verdict>,
): Promise<Verdict> {
  const number = ++asked;
  verdict.value = { kind: "busy", what };
  let found: Verdict;
  try {
    found = await judge(await prover());
  } catch (error) {
    if (!(error instanceof RefusedError)) engine = undefined;
    found = { kind: "refused", message: error instanceof Error ? error.message : String(error) };
  }
  if (number === asked) verdict.value = found;
  return verdict.value;
}

/** Searches all interleavings; a failing run is then on the card. */
export async function explore(isCheck = false): Promise<void> {
  const explored = project.value;
  const found = await judged(isCheck ? "check" : "explore", async (started) => {
    const exploration = await started.explore(explored, language.value);
    if (!exploration.compiled) return { kind: "not-compiled" };
    return { kind: "explored", exploration, isCheck };
  });
  if (found.kind === "explored" && found.exploration.schedule !== undefined) {
    await bench.loadRecording(explored, found.exploration.schedule);
  }
}

/** Checks the task of the lesson. */
export async function checkTask(): Promise<void> {
  const { id, task } = lesson.value;
  if (task === "explore") await explore(true);
  else {
    await judged("check", async (started) => {
      const { run } = await started.run(project.value);
      return run ? { kind: "run", run } : { kind: "not-compiled" };
    });
  }
  if (isSolvedNow.value && lesson.value.id === id) {
    solved.value = new Set([...solved.value, id]);
    keep("solved", [...solved.value]);
  }
}

/** Ends a check or an exploration. */
export function stopCheck(): void {
  ++asked;
  void engine?.then((started) => {
    started.close();
  });
  engine = undefined;
  verdict.value = { kind: "stopped" };
}

/** What was said of another program is no longer of use. */
export function forgetVerdict(): void {
  if (verdict.value.kind === "busy") stopCheck();
  verdict.value = { kind: "none" };
}
