// Where the user wants to stop: breakpoints of all kinds and exception filters. They are installed
// in the engine together; one that it refuses is marked with the reason, and the others stay.

import type { Engine, LineStop, Stop, StopWishes } from "@oncard/engine";
import { RefusedError } from "@oncard/engine";

/** A breakpoint. */
export interface Wish {
  id: number;
  /** Missing if it was refused before the engine could be asked. */
  at?: { line: LineStop } | { change: string };
  /** What the editor calls a stop at it, if that is not a breakpoint. */
  reason?: "instruction breakpoint" | "entry";
  /** The line to which it was moved. */
  line?: number;
  /** Why it is not installed. */
  refused?: string;
}

export type Filter = "fault" | "refusal" | "requirement" | "race" | "warning";

/** Those that are set unless the user says otherwise. */
export const usualFilters: readonly Filter[] = ["fault", "refusal", "requirement"];

/** The group of a stop that the user did not set as a breakpoint. */
const onceGroup = "once";

export class Stops {
  /** By source, and by kind for those that have no source. */
  readonly #wishes = new Map<string, Wish[]>();
  #filters = new Set<string>(usualFilters);
  #lines: Wish[] = [];
  #changes: Wish[] = [];
  #ids = 0;

  /** Replaces the breakpoints of a group. */
  replace(group: string, wishes: readonly Omit<Wish, "id">[]): Wish[] {
    const all = wishes.map((wish) => ({ ...wish, id: ++this.#ids }));
    this.#wishes.set(group, all);
    return all;
  }

  /** Replaces the breakpoints of a group by what they are in another program. */
  renew(group: string, wishes: readonly Omit<Wish, "id">[]): Wish[] {
    const before = this.#wishes.get(group) ?? [];
    const all = wishes.map((wish, i) => ({ ...wish, id: before[i]?.id ?? ++this.#ids }));
    this.#wishes.set(group, all);
    return all;
  }

  filter(filters: readonly string[]): void {
    this.#filters = new Set(filters);
  }

  /** Stops once before the first statement of a function; before all others at the same place. */
  once(name: string | undefined): void {
    const wish: Omit<Wish, "id"> = { at: { line: { function: name ?? "" } }, reason: "entry" };
    this.replace(onceGroup, name === undefined ? [] : [wish]);
  }

  /** Takes back the stop of `once`, if that is the wish. */
  async passed(wish: Wish | undefined, engine: Engine): Promise<void> {
    if (!wish || !this.#wishes.get(onceGroup)?.includes(wish)) return;
    this.once(undefined);
    await this.install(engine);
  }

  /** Installs everything; wishes that the engine refuses are marked. */
  async install(engine: Engine): Promise<void> {
    try {
      await this.#set(engine);
    } catch (error) {
      if (!(error instanceof RefusedError)) throw error;
      for (const wish of this.#good()) await this.#probe(engine, wish);
      await this.#set(engine);
    }
  }

  /** The breakpoint at which the engine has stopped. */
  reached(stop: Stop): Wish | undefined {
    const wishes = stop.reason === "change" ? this.#changes : this.#lines;
    return stop.number === undefined ? undefined : wishes[stop.number];
  }

  /** All wishes that have not been refused. */
  #good(): Wish[] {
    return [...this.#wishes.values()].flat().filter((wish) => wish.refused === undefined);
  }

  /** Asks for one wish alone. */
  async #probe(engine: Engine, wish: Wish): Promise<void> {
    try {
      await engine.setStops(wishesOf([wish]));
    } catch (error) {
      if (!(error instanceof RefusedError)) throw error;
      wish.refused = error.message;
    }
  }

  async #set(engine: Engine): Promise<void> {
    const good = this.#good();
    const { lines } = await engine.setStops({
      ...wishesOf(good),
      faults: this.#filters.has("fault"),
      refusals: this.#filters.has("refusal"),
      requirements: this.#filters.has("requirement"),
      races: this.#filters.has("race"),
      warnings: this.#filters.has("warning"),
    });
    this.#lines = good.filter(({ at }) => at && "line" in at);
    this.#changes = good.filter(({ at }) => at && "change" in at);
    for (const [i, wish] of this.#lines.entries()) {
      const line = lines[i];
      if (line !== undefined) wish.line = line;
    }
  }
}

function wishesOf(wishes: readonly Wish[]): StopWishes {
  return {
    lines: wishes.flatMap(({ at }) => (at && "line" in at ? [at.line] : [])),
    changes: wishes.flatMap(({ at }) => (at && "change" in at ? [at.change] : [])),
  };
}

/** `5` or `>= 5`: from the fifth arrival on. */
export function readHits(text: string): number | undefined {
  const digits = /^\s*(?:>=)?\s*(\d+)\s*$/.exec(text)?.[1];
  return digits === undefined ? undefined : Number(digits);
}
