// The failing run that the last exploration has found, and its place on the card.

import { type Executed, type Interleaving, type Project, statementsOf } from "@oncard/engine";
import { computed } from "@preact/signals";

import { bench, present, session } from "../session/bench.js";
import { forgetRecord } from "../session/record.js";
import { seek } from "../session/seeking.js";
import { slice } from "../store/slice.js";
import { useAsked } from "../session/asked.js";

export interface FailingRun {
  project: Project;
  /** A schedule file that repeats it. */
  schedule: string;
  interleaving: Interleaving;
}

/** More turns than this are not asked for. */
const mostTurns = 50_000;

const [{ run, history }, change] = slice<{
  run: FailingRun | undefined;
  /** That of the session with the run on the card. */
  history: number;
}>({ run: undefined, history: -1 });
export { run as failingRun };

/** Whether the card follows it: nothing else was loaded, chosen or changed since. */
export const isOnCard = computed(
  () => run.value !== undefined && history.value === session.history.value,
);

/** Puts it onto the card, at its end. */
export async function showFailingRun(found: FailingRun): Promise<void> {
  forgetRecord();
  const loaded = await bench.loadRecording(found.project, found.schedule);
  change({ run: found, history: loaded ?? -1 });
}

export function forgetFailingRun(): void {
  change({ run: undefined });
}

async function statementsOnCard(): Promise<Executed[]> {
  const head = present.state.peek()?.head ?? 0;
  return statementsOf(await (await bench.engine()).turns(0, head, mostTurns));
}

/** The steps of the failing run, as they were executed; undefined if it is not on the card. */
export function useStepsOnCard(): Executed[] | undefined {
  const key = `${session.history.value} ${present.state.value?.head ?? 0} ${isOnCard.value}`;
  const skipped = run.value?.interleaving.skipped ?? 0;
  const asked = useAsked(
    key,
    async () => ({ key, steps: isOnCard.peek() ? await statementsOnCard() : [] }),
    session.running.value,
  );
  return isOnCard.value && asked?.key === key ? asked.steps.slice(skipped) : undefined;
}

/** The card is then after this step of it. */
export async function goToStep(step: number): Promise<void> {
  const { value: found } = run;
  if (!found) return;
  if (!isOnCard.peek()) await showFailingRun(found);
  const executed = (await statementsOnCard())[found.interleaving.skipped + step - 1];
  if (executed && run.peek() === found) seek(executed.moment);
}
