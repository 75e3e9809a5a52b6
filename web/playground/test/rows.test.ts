import type { ThreadSpan } from "@oncard/engine";
import { describe, expect, test } from "vitest";

import {
  barsOf,
  following,
  marksOf,
  momentAt,
  momentOf,
  moved,
  readable,
  ticks,
  timeAt,
  timesOf,
  withPresent,
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

describe("marks of states", () => {
  const state = (from: number, to: number, rest: Partial<ThreadSpan> = {}): ThreadSpan => ({
    thread: 0,
    state: "running",
    line: 7,
    from,
    to,
    from_ms: 0.25,
    to_ms: 0.5,
    ...rest,
  });
  const waits = { until_ms: 3 };
  const whole = { from: 0, to: 100 };

  test("are waits and pauses as parts of the span, and faults where they happen", () => {
    const spans = [
      state(0, 10),
      state(10, 40, { waits }),
      state(20, 50, { thread: 1, state: "paused" }),
      state(40, 50),
      state(50, 100, { state: "faulted", text: "division by zero" }),
      state(60, 100, { thread: 1, state: "finished" }),
    ];
    expect(marksOf(spans, whole)).toEqual([
      { thread: 0, kind: "waits", from: 0.1, to: 0.4, of: spans[1] },
      { thread: 1, kind: "paused", from: 0.2, to: 0.5, of: spans[2] },
      { thread: 0, kind: "faulted", from: 0.5, to: 0.5, of: spans[4] },
    ]);
  });

  test("are cut at the ends of the span; a fault before it has no mark", () => {
    const spans = [
      state(0, 60, { waits }),
      state(40, 200, { thread: 1, state: "faulted" }),
      state(90, 200, { waits }),
    ];
    expect(marksOf(spans, { from: 50, to: 100 })).toMatchObject([
      { from: 0, to: 0.2 },
      { from: 0.8, to: 1 },
    ]);
  });

  test("of a fault in the last moment", () => {
    expect(marksOf([state(100, 100, { state: "faulted" })], whole)).toMatchObject([
      { kind: "faulted", from: 1, to: 1 },
    ]);
  });

  test("that cannot be told apart become one, of which nothing more is said", () => {
    const spans = Array.from({ length: 5000 }, (_, index) =>
      state(2 * index, 2 * index + 1, { waits }),
    );
    const marks = marksOf(spans, { from: 0, to: 10_000 });
    expect(marks).toEqual([{ thread: 0, kind: "waits", from: 0, to: 0.9999 }]);
  });
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

describe("the scale in ms", () => {
  const at = (moment: number, ms: number, statements: number) => ({
    ...turn(moment, 0, statements),
    time_ms: ms,
  });
  // 10 statements before the first cycle of 0.25 ms, then 20 cycles, 4 statements, and cycles.
  const turns = [at(0, 0, 10), at(30, 5, 4)];
  const whole = { from: 0, to: 100 };
  const times = timesOf(turns, [], whole);

  test.each([
    [0, 0],
    [10, 0],
    [20, 2.5],
    [30, 5],
    [34, 5],
    [54, 10],
  ])("moment %i is at %f ms", (moment, ms) => {
    expect(timeAt(times, 0.25, moment)).toBe(ms);
  });

  test("a time is where it begins: statements take none", () => {
    expect([2.5, 5, 10].map((ms) => momentOf(times, 0.25, ms))).toEqual([20, 30, 54]);
  });

  test("the present moment is known before anything else is", () => {
    const present = { moment: 40, ms: 8 };
    expect(withPresent([], present)).toEqual([{ moment: 0, ms: 0 }, present]);
    expect(timeAt(withPresent(times, present), 0.25, 37)).toBe(6.5);
  });

  test("where no statement is executed, the states of threads say the time", () => {
    const waits: ThreadSpan = {
      ...{ thread: 0, state: "running", line: 1, waits: { until_ms: 9 } },
      ...{ from: 34, to: 84, from_ms: 5, to_ms: 17.5 },
    };
    const within = timesOf([], [waits], { from: 40, to: 60 });
    expect(timeAt(within, 0.25, 40)).toBe(6.5);
  });
});

test("numbers of the scale that would lie upon each other are left out", () => {
  const marks = [-0.1, 0, 0.05, 0.2, 0.4, 0.6, 1.1].map((at) => ({ at, text: String(at) }));
  expect(readable(marks, [0.3, 0.5]).map(({ at }) => at)).toEqual([0, 0.2, 0.6]);
});
