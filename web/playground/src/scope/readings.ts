// What is read of a channel at the cursors. Tested by test/readings.test.ts.

import { number } from "../texts/number.js";
import { type Drawn, readingAt } from "./channels.js";
import type { Sweep } from "./trigger.js";

export interface Reading {
  /** The values at the cursors; empty where there are none. */
  texts: [string, string];
  /** From A to B; of curves alone. */
  gain?: number;
  /** The same in a millisecond. */
  slope?: number;
}

export function readingOf(
  sweep: Sweep,
  { name, isDigital }: Drawn,
  [a, b]: [number, number],
): Reading {
  const atA = readingAt(sweep, name, a);
  const atB = readingAt(sweep, name, b);
  const text = (reading: typeof atA) => {
    if (!reading) return "";
    const { least, largest } = reading;
    return isDigital && least !== largest ? `${least}…${largest}` : number(largest);
  };
  const texts: [string, string] = [text(atA), text(atB)];
  if (isDigital || !atA || !atB) return { texts };
  const gain = atB.largest - atA.largest;
  return a === b ? { texts, gain } : { texts, gain, slope: gain / (b - a) };
}

/** The unit of what is gained in a millisecond. */
export function perMs(unit = "1"): string {
  if (unit.endsWith("/ms²")) return unit.replace(/²$/, "³");
  return unit.endsWith("/ms") ? `${unit}²` : `${unit}/ms`;
}
