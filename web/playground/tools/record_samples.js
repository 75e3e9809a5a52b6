// The small pictures of the samples, from runs of them in the module: what moves, in hundredths.

import { readFileSync } from "node:fs";

import { Engine, ModuleTransport } from "@oncard/engine";
import { EngineModule } from "@oncard/engine/engine_module.js";

/** Of a run, so many places are kept. */
const places = 60;

/** Values in hundredths of their common range. */
function inHundredths(rows) {
  const all = rows.flat();
  const least = Math.min(...all);
  const range = Math.max(...all) - least || 1;
  return rows.map((row) => row.map((value) => Math.round((100 * (value - least)) / range)));
}

/** Who ran when; what one thread does in a row is one bar. */
function barsOf(turns, head) {
  const bars = [];
  for (const { thread, moment, statements } of turns) {
    const [from, to] = [moment, moment + statements].map((at) => Math.round((100 * at) / head));
    const last = bars.at(-1);
    if (last && last[0] === thread && from <= last[2]) last[2] = to;
    else bars.push([thread, from, to]);
  }
  return bars;
}

async function record(engine, { lesson, picture: kind }) {
  const { main, files, scope } = lesson;
  const { compiled } = await engine.load({ main, files });
  if (!compiled) throw new Error(`${lesson.id} does not compile`);
  const { state } = await engine.walkForward({ goal: "end" });
  if (kind === "threads") {
    return { kind, turns: barsOf(await engine.turns(0, state.head), state.head) };
  }
  const axes = [...new Set(scope.flatMap((name) => /^axis\d+/.exec(name) ?? []))];
  const names = axes.map((axis) => `${axis}.prfPos`);
  // The last value of each part; the first part also has what was before the first statement.
  const trace = await engine.trace(names, 0, state.time_ms, places);
  const rows = inHundredths(trace.map(({ largest }) => largest));
  if (rows.every((row) => row.every((value) => value === row[0]))) {
    throw new Error(`nothing moves in the picture of ${lesson.id}`);
  }
  return { kind, axes: rows };
}

/** The picture of each sample, by its name. */
export async function recordSamples(module, samples) {
  const engine = new Engine(new ModuleTransport(await EngineModule.create(readFileSync(module))));
  const pictures = {};
  for (const sample of samples) pictures[sample.lesson.id] = await record(engine, sample);
  engine.close();
  return pictures;
}
