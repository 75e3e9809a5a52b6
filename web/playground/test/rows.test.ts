import { expect, test } from "vitest";

import {
  barsOf,
  following,
  momentAt,
  moved,
  ticks,
  wholeRun,
  zoomed,
} from "../src/timeline/rows.js";

const turn = (moment: number, thread: number, statements: number) => ({
  moment,
  time_ms: 0.25,
  thread,
  statements,
});

test("bars are the turns as parts of the span", () => {
  const turns = [turn(0, 0, 5), turn(10, 0, 40), turn(50, 1, 25), turn(120, 0, 1)];
  expect(barsOf(turns, { from: 0, to: 100 })).toEqual([
    { thread: 0, from: 0, to: 0.05 },
    { thread: 0, from: 0.1, to: 0.5 },
    { thread: 1, from: 0.5, to: 0.75 },
  ]);
});

test("bars are cut at the ends of the span", () => {
  const bars = barsOf([turn(0, 0, 60), turn(90, 0, 60)], { from: 50, to: 100 });
  expect(bars).toEqual([
    { thread: 0, from: 0, to: 0.2 },
    { thread: 0, from: 0.8, to: 1 },
  ]);
});

test("turns that cannot be told apart become one bar", () => {
  const turns = Array.from({ length: 10_000 }, (_, index) => turn(2 * index, index % 2, 1));
  const bars = barsOf(turns, { from: 0, to: 20_000 });
  expect(bars).toHaveLength(2);
  expect(bars[0]).toEqual({ thread: 0, from: 0, to: 19_997 / 20_000 });
});

test("a short run has room around it", () => {
  expect(wholeRun(3)).toEqual({ from: 0, to: 20 });
  expect(wholeRun(300)).toEqual({ from: 0, to: 300 });
});

test("a zoom keeps its moment in place", () => {
  expect(zoomed({ from: 0, to: 1000 }, 0.5, 500, 1000)).toEqual({ from: 250, to: 750 });
  expect(zoomed({ from: 250, to: 750 }, 4, 500, 1000)).toEqual({ from: 0, to: 1000 });
  expect(zoomed({ from: 0, to: 24 }, 0.5, 0, 1000)).toEqual({ from: 0, to: 20 });
});

test("the span stays within the run", () => {
  expect(moved({ from: -10, to: 90 }, 500)).toEqual({ from: 0, to: 100 });
  expect(moved({ from: 450, to: 550 }, 500)).toEqual({ from: 400, to: 500 });
});

test("the span follows the session", () => {
  expect(following({ from: 0, to: 100 }, 50, 500)).toEqual({ from: 0, to: 100 });
  expect(following({ from: 0, to: 100 }, 300, 500)).toEqual({ from: 225, to: 325 });
  expect(following({ from: 300, to: 400 }, 200, 500)).toEqual({ from: 175, to: 275 });
});

test("moments at places of the track", () => {
  expect(momentAt({ from: 100, to: 200 }, 0.5, 500)).toBe(150);
  expect(momentAt({ from: 0, to: 20 }, 0.9, 3)).toBe(3);
  expect(momentAt({ from: 0, to: 20 }, -0.1, 3)).toBe(0);
});

test("the scale has round steps", () => {
  expect(ticks({ from: 0, to: 20 }, 6)).toEqual([0, 5, 10, 15, 20]);
  expect(ticks({ from: 130, to: 770 }, 6)).toEqual([200, 400, 600]);
});
