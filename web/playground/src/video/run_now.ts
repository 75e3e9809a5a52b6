// The run of the session as its frames show it. Nothing on the card is moved for it.

import { type Card, RefusedError } from "@oncard/engine";

import type { AxisView, TableAxes } from "../machine/axes.js";
import { machine } from "../machine/now.js";
import { tableOf } from "../machine/view.js";
import { unitsOf } from "../scope/channels.js";
import { pinName, pinNames } from "../scope/digital.js";
import { scope } from "../scope/settings.js";
import { bench, present, session } from "../session/bench.js";
import { record } from "../session/record.js";
import { settings } from "../store/settings.js";
import { source } from "../store/source.js";
import { texts } from "../texts/texts.js";
import { carriageOf, curvesOf, lampPins, lampsOf, shownAxis, type ShownRun } from "./run.js";

/** The time of a run is divided into so many parts: about a pixel of the screen. */
const parts = 900;

/** Everything that the run depends on. */
export function runKey(): string {
  return JSON.stringify([
    present.state.value?.time_ms ?? 0,
    session.history.value,
    scope.channels.value,
    settings.language.value,
  ]);
}

/** From its start to the present; nothing if no time has passed. */
export async function runNow(): Promise<ShownRun | undefined> {
  const now = machine.peek();
  const endMs = present.state.peek()?.time_ms ?? 0;
  if (!now || endMs === 0) return undefined;
  const { card } = now;
  const t = texts.peek();
  const engine = await bench.engine();
  const channels = scope.channels.peek();
  const names = channels.map(({ name }) => name);
  const known = new Set(card.parts.flatMap(({ values }) => values.map(({ path }) => path)));
  const table = tableOf(card, now.axes);
  const axes = tableFirst(now.axes, table);
  // A table shows where its axes are commanded to be, as in the machine view.
  const positions = axes.map(({ axis }) =>
    table ? `axis${axis}.prfPos` : carriageOf(axis, known),
  );
  const moved = await engine.trace(positions, 0, endMs, parts);
  const traced =
    names.length === 0 ? [] : await engine.trace(names, 0, endMs, parts).catch(withoutCurves);
  const wanted = shownPins(card, axes);
  const pins = wanted.length === 0 ? [] : await engine.trace(wanted, 0, endMs, parts);
  const pinTraces = new Map(pins.map((trace) => [trace.name, trace]));
  return {
    title: record.peek() ? t.record.title : source.lesson.peek().title[settings.language.peek()],
    endMs,
    axes: axes.flatMap((axis, index) => {
      const trace = moved[index];
      return trace ? [shownAxis(axis, t.machine.axis(axis.axis), trace, pinTraces)] : [];
    }),
    isTable: table !== undefined,
    lamps: lampsOf(card, pinTraces),
    curves: curvesOf(traced, channels, unitsOf(card), endMs, t.scope.scaleOf),
  };
}

/** The pins of switches, and those that may become lamps. */
function shownPins(card: Card, axes: readonly AxisView[]): string[] {
  const wanted = [...lampPins(card), ...axes.flatMap(({ switches }) => switches)];
  const names = new Set(wanted.map(({ type, index }) => pinName(type, index)));
  return pinNames(card, present.globals.peek()).filter((name) => names.has(name));
}

/** The axes of a table are the first ones of its run. */
function tableFirst(axes: readonly AxisView[], table: TableAxes | undefined): readonly AxisView[] {
  if (!table) return axes;
  const { x, y } = table;
  return [x, y, ...axes.filter((axis) => axis !== x && axis !== y)];
}

/** The scope has none either of channels that the program does not have. */
function withoutCurves(error: unknown): [] {
  if (error instanceof RefusedError) return [];
  throw error;
}
