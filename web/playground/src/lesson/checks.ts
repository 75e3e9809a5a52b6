// Whether the open program solves its task, and what an exploration finds. Runs have an engine of
// their own, and so have explorations: the session stays alive, and ending an engine stops them.

import type { Engine, ExploreAnswer, Project, RunAnswer } from "@oncard/engine";
import { RefusedError } from "@oncard/engine";
import { computed, effect, untracked } from "@preact/signals";

import { forgetFailingRun, showFailingRun } from "../interleaving/failing_run.js";
import { type Purpose, startModule } from "../session/engines.js";
import { markSolved } from "../store/lessons.js";
import { ownProgram } from "../store/own_program.js";
import { settings } from "../store/settings.js";
import { slice } from "../store/slice.js";
import { source } from "../store/source.js";

/** What a check says. `isHidden`: of a scenario that the reader does not see. */
export type Verdict =
  | { kind: "none" }
  | { kind: "busy"; what: "check" | "explore" }
  | { kind: "stopped" }
  | { kind: "not-compiled" }
  | { kind: "refused"; message: string }
  | { kind: "run"; run: NonNullable<RunAnswer["run"]>; isHidden: boolean }
  | { kind: "explored"; exploration: ExploreAnswer; isCheck: boolean; isHidden: boolean };

const [{ verdict }, change] = slice<{ verdict: Verdict }>({ verdict: { kind: "none" } });
export { verdict };

function say(said: Verdict): void {
  forgetFailingRun();
  change({ verdict: said });
}

/** Whether the verdict says that the task is solved. */
export const isSolvedNow = computed(() => solves(verdict.value));

function solves(said: Verdict): boolean {
  if (said.kind === "run") return said.run.passed;
  return said.kind === "explored" && said.exploration.report?.verdict === "PROVED";
}

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

/**
 * The program with each scenario for which the task must hold: that of the lesson, which the reader
 * may change for runs alone, then those that nobody sees.
 */
function projectsOfTask(): Project[] {
  const project = source.project.peek();
  const { id, main, files, hidden = [] } = source.lesson.peek();
  const task = files[main];
  if (id === ownProgram.id || task === undefined) return [project];
  const withScenario = (name: string, text: string) => ({
    ...project,
    main: name,
    files: { ...project.files, [name]: text },
  });
  return [
    project.files?.[main] === task ? project : withScenario(main, task),
    ...hidden.map((text, index) => withScenario(`hidden-${index + 1}.toml`, text)),
  ];
}

/** Searches all interleavings; a failing run is then on the card. */
export async function explore(): Promise<void> {
  await exploreAll("explore", [source.project.peek()]);
}

/** The first exploration that does not prove its project, or that of the first one. */
async function exploreAll(what: "check" | "explore", projects: Project[]): Promise<void> {
  let explored: Project | undefined;
  const isCheck = what === "check";
  const found = await judged(what, "explorations", async (started) => {
    return firstFailing(projects, async (project, isHidden) => {
      explored = project;
      const exploration = await started.explore(project, settings.language.peek());
      if (!exploration.compiled) return { kind: "not-compiled" };
      return { kind: "explored", exploration, isCheck, isHidden };
    });
  });
  if (!explored || found.kind !== "explored") return;
  const { schedule, interleaving } = found.exploration;
  if (schedule !== undefined && interleaving) {
    await showFailingRun({ project: explored, schedule, interleaving });
  }
}

async function firstFailing(
  projects: Project[],
  judge: (project: Project, isHidden: boolean) => Promise<Verdict>,
): Promise<Verdict> {
  let first: Verdict | undefined;
  for (const [index, project] of projects.entries()) {
    const found = await judge(project, index > 0);
    if (!solves(found)) return found;
    first ??= found;
  }
  return first ?? { kind: "none" };
}

/** Checks the task of the lesson. */
export async function checkTask(): Promise<void> {
  const { id, task } = source.lesson.peek();
  const projects = projectsOfTask();
  if (task === "explore") await exploreAll("check", projects);
  else {
    await judged("check", "programs", (started) =>
      firstFailing(projects, async (project, isHidden) => {
        const { run } = await started.run(project);
        return run ? { kind: "run", run, isHidden } : { kind: "not-compiled" };
      }),
    );
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
