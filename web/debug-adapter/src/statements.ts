// Places of a run by the numbers of its statements, which reports of explorations have, too.
// Tested by test/moving.test.ts.

import {
  type Engine,
  type Executed,
  executedAt,
  type State,
  statementsOf,
  type Turn,
} from "@oncard/engine";

import type { Movement } from "./movements.js";

/** The engine gives no more at once. */
const mostTurns = 100_000;

/** How many statements have been executed where the card stands. */
export async function statementsUntil(engine: Engine, { moment }: State): Promise<number> {
  return executedAt(await statementsIn(engine, moment), moment);
}

/** To after a statement, counted from 1; to the end of a run that has fewer. */
export function toStatement(number: number): Movement {
  return {
    reason: "step",
    walk: async (engine, options) => {
      let statements = await statementsIn(engine, (await engine.state()).head);
      if (statements.length < number) {
        const walked = await engine.walkForward({ goal: "end" }, options);
        statements = await statementsIn(engine, walked.state.head);
        if (statements.length < number) return walked;
      }
      const moment = statements[number - 1]?.moment ?? 0;
      return { stop: { reason: "goal" }, state: await engine.goTo({ moment }) };
    },
  };
}

/** Those of the run up to a moment that has been reached. */
async function statementsIn(engine: Engine, to: number): Promise<Executed[]> {
  let turns: Turn[] = [];
  for (let from = 0; ; ) {
    const next = await engine.turns(from, to, mostTurns);
    turns = turns.concat(next);
    const last = next.at(-1);
    if (!last || next.length < mostTurns) return statementsOf(turns);
    from = last.moment + last.statements;
  }
}
