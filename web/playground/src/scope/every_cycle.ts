// The values at the end of each cycle, one for each channel: what a recorder of the card would write.
// Tested by test/every_cycle.test.ts.

import type { Engine } from "@oncard/engine";

import { titleOf, type Units } from "./channels.js";

/** The engine answers for so many cycles at once. */
const mostAtOnce = 100_000;

/** Cycles count from 1; the first one ends after one cycle's time. */
interface Cycles {
  first: number;
  last: number;
  /** How long a cycle is. */
  ms: number;
}

/** The cycles that end in a part of the run. All are equally long, as on cards with motion programs. */
export function cyclesIn(
  window: { fromMs: number; endMs: number },
  present: { cycle: number; time_ms: number },
): Cycles {
  if (present.cycle === 0) return { first: 1, last: 0, ms: 1 };
  const ms = present.time_ms / present.cycle;
  // A time that is given as a fraction may miss the end of its cycle by a rounding.
  const tolerance = 1e-6;
  return {
    first: Math.max(1, Math.ceil(window.fromMs / ms - tolerance)),
    last: Math.min(present.cycle, Math.floor(window.endMs / ms + tolerance)),
    ms,
  };
}

/** A table with a row for each cycle. */
export async function csvOfCycles(
  engine: Pick<Engine, "trace">,
  names: string[],
  { first, last, ms }: Cycles,
  units: Units,
): Promise<string> {
  const table = [["time [ms]", ...names.map((name) => titleOf(name, units))].join(",")];
  for (let begin = first; begin <= last && names.length > 0; begin += mostAtOnce) {
    const end = Math.min(last, begin + mostAtOnce - 1);
    // Each part of the time has the end of one cycle in its middle.
    const [fromMs, toMs] = [(begin - 0.5) * ms, (end + 0.5) * ms];
    const channels = await engine.trace(names, fromMs, toMs, end - begin + 1);
    for (let cycle = begin; cycle <= end; ++cycle) {
      const values = channels.map(({ largest }) => largest[cycle - begin] ?? "");
      table.push([Number((cycle * ms).toFixed(6)), ...values].join(","));
    }
  }
  return `${table.join("\n")}\n`;
}
