import { expect, test } from "vitest";

import { engineOf } from "../../engine/test/support.js";
import { csvOfCycles, cyclesIn } from "../src/scope/every_cycle.js";

const present = { cycle: 40, time_ms: 10 };

test.each([
  [0, 10, 1, 40],
  [1, 2, 4, 8],
  [1.1, 2.1, 5, 8],
  [9.9, 10, 40, 40],
  [0, 99, 1, 40],
])("the cycles from %d to %d ms", (fromMs, endMs, first, last) => {
  expect(cyclesIn({ fromMs, endMs }, present)).toEqual({ first, last, ms: 0.25 });
});

test("before the first cycle there is none", () => {
  const { first, last } = cyclesIn({ fromMs: 0, endMs: 10 }, { cycle: 0, time_ms: 0 });
  expect(last).toBeLessThan(first);
});

const program = "int main()\n{\n  GT_Delay(100);\n}\n";

test("each cycle has a row with its values, in the units of the channels", async () => {
  const engine = await engineOf(program);
  await engine.walkForward({ goal: "time", ms: 3 });
  const cycles = cyclesIn({ fromMs: 0.9, endMs: 2 }, await engine.state());
  const csv = await csvOfCycles(engine, ["clock", "gpo"], cycles, new Map([["clock", "ms"]]));
  // The clock counts whole milliseconds.
  const rows = ["1,1,0", "1.25,1,0", "1.5,1,0", "1.75,1,0", "2,2,0"];
  expect(csv).toBe(`${["time [ms],clock [ms],gpo", ...rows].join("\n")}\n`);
});

test("many cycles are asked for in parts, none twice and none left out", async () => {
  const asked: number[] = [];
  const trace = (names: string[], fromMs: number, _toMs: number, points: number) => {
    asked.push(points);
    const values = Array.from({ length: points }, (_, index) => fromMs + 0.5 + index);
    return Promise.resolve(names.map((name) => ({ name, least: values, largest: values })));
  };
  const csv = await csvOfCycles({ trace }, ["a"], { first: 1, last: 150_000, ms: 1 }, new Map());
  expect(asked).toEqual([100_000, 50_000]);
  const rows = csv.trim().split("\n").slice(1);
  expect(rows).toHaveLength(150_000);
  expect(rows.every((row, index) => row === `${index + 1},${index + 1}`)).toBe(true);
});

test("without channels there are only the titles", async () => {
  const engine = await engineOf(program);
  expect(await csvOfCycles(engine, [], { first: 1, last: 4, ms: 1 }, new Map())).toBe(
    "time [ms]\n",
  );
});
