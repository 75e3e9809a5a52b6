// Whether the open program solves its task, and what an exploration finds. Runs have an engine of
// their own, and so have explorations: the session stays alive, and ending an engine stops them.

import type { Engine, ExploreAnswer, Project, RunAnswer } from "@oncard/engine";
import { RefusedError } from "@oncard/engine";
import { computed, effect, untracked } from "@preact/signals";

import { bench } from "../session/bench.js";
import { type Purpose, startModule } from "../session/engines.js";
import { forgetRecord } from "../session/record.js";
import { markSolved } from "../store/lessons.js";
import { ownProgram } from "../store/own_program.js";
import { settings } from "../store/settings.js";
import { slice } from "../store/slice.js";
import { source } from "../store/source.js";

/** What a check says. */
export type Verdict =
  | { kind: "none" }
  | { kind: "busy"; what: "check" | "explore" }
  | { kind: "stopped" }
  | { kind: "not-compiled" }
  | { kind: "refused"; message: string }
  | { kind: "run"; run: NonNullable<RunAnswer["run"]> }
  | { kind: "explored"; exploration: ExploreAnswer; isCheck: boolean };

const [{ verdict }, change] = slice<{ verdict: Verdict }>({ verdict: { kind: "none" } });
export { verdict };

function say(said: Verdict): void {
  change({ verdict: said });
}

/** Whether the verdict says that the task is solved. */
export const isSolvedNow = computed(() => {
  const { value } = verdict;
  if (value.kind === "run") return value.run.passed;
  return value.kind === "explored" && value.exploration.report?.verdict === "PROVED";
});

const engines = new Map<Purpose, Promise<Engine>>();
let asked = 0;

async function engineFor(purpose: Purpose): Promise<Engine> {
  const engine = engines.get(purpose) ?? startModule(purpose);
  engines.set(purpose, engine);
  const started = await engine;
  started.onEnded = () => {
    engines.delete(purpose);
  };
  await started.hello(settings.language.peek());
  return started;
}

async function judged(
  what: "check" | "explore",
  purpose: Purpose,
  judge: (engine: Engine) => Promise<Verdict>,
): Promise<Verdict> {
  const number = ++asked;
  say({ kind: "busy", what });
  let found: Verdict;
  try {
    found = await judge(await engineFor(purpose));
  } catch (error) {
    if (!(error instanceof RefusedError)) engines.delete(purpose);
    found = { kind: "refused", message: error instanceof Error ? error.message : String(error) };
  }
  if (number === asked) say(found);
  return verdict.value;
}

/** The program with the task as the lesson has it: the reader may change it for runs alone. */
function projectOfTask(): Project {
  const project = source.project.peek();
  const { id, main, files } = source.lesson.peek();
  const task = files[main];
  if (id === ownProgram.id || task === undefined) return project;
  return { ...project, files: { ...project.files, [main]: task } };
}

/** Searches all interleavings; a failing run is then on the card. */
export async function explore(isCheck = false): Promise<void> {
  const loaded = source.project.peek();
  const explored = isCheck ? projectOfTask() : loaded;
  const what = isCheck ? "check" : "explore";
  const found = await judged(what, "explorations", async (started) => {
    const exploration = await started.explore(explored, settings.language.peek());
    if (!exploration.compiled) return { kind: "not-compiled" };
    return { kind: "explored", exploration, isCheck };
  });
  if (found.kind === "explored" && found.exploration.schedule !== undefined) {
    forgetRecord();
    await bench.loadRecording(loaded, found.exploration.schedule);
  }
}

/** Checks the task of the lesson. */
export async function checkTask(): Promise<void> {
  const { id, task } = source.lesson.peek();
  if (task === "explore") await explore(true);
  else {
    await judged("check", "programs", async (started) => {
      const { run } = await started.run(projectOfTask());
      return run ? { kind: "run", run } : { kind: "not-compiled" };
    });
  }
  if (isSolvedNow.value && source.lesson.peek().id === id) markSolved(id);
}

/** Ends a check or an exploration. */
export function stopCheck(): void {
  ++asked;
  for (const engine of engines.values()) {
    void engine.then((started) => {
      started.close();
    });
  }
  engines.clear();
  say({ kind: "stopped" });
}

/** What was said of another text is no longer of use. */
export function forgetOldVerdicts(): void {
  effect(() => {
    source.project.value; // eslint-disable-line @typescript-eslint/no-unused-expressions
    untracked(() => {
      if (verdict.value.kind === "busy") stopCheck();
      say({ kind: "none" });
    });
  });
}
