import { expect, test } from "vitest";

import { engineOf } from "./support.js";

const endless = "int x;\nint f()\n{\nagain:\n  x = x + 1;\n  goto again;\n}\n";
const counting = `int x;
int f()
{
  int c;
again:
  x = x + 1;
  c = x < 500;
  if (c) goto again;
}
`;

test("a walk goes on until it arrives", async () => {
  const engine = await engineOf(counting);
  let slices = 0;
  const options = { slice: 100, onSlice: () => ++slices };
  const { stop } = await engine.walkForward({ goal: "stop" }, options);
  expect(stop).toEqual({ reason: "end", failed: [] });
  expect(slices).toBeGreaterThan(10); // 1501 statements
});

test("slices do not change where a walk arrives", async () => {
  for (const walk of [
    { goal: "time", ms: 7.5 },
    { goal: "cycle" },
    { goal: "rest" },
    { goal: "line", thread: 0 },
  ] as const) {
    const whole = await (await engineOf(counting)).walkForward(walk);
    const sliced = await (await engineOf(counting)).walkForward(walk, { slice: 7 });
    expect(sliced, walk.goal).toEqual(whole);
  }
});

test("a walk back goes on until it arrives", async () => {
  const engine = await engineOf(counting);
  await engine.walkForward({ goal: "stop" });
  const { state } = await engine.walkBack({ goal: "change", name: "x" }, { slice: 10 });
  expect(state.threads).toMatchObject([{ line: 6 }]);
  expect(await engine.evaluate("x")).toEqual({ value: 499, path: "x" });
});

test("a program without an end can be paused, and goes on", async () => {
  const engine = await engineOf(endless);
  const pause = new AbortController();
  const onSlice = () => {
    pause.abort();
  };
  const first = await engine.walkForward({ goal: "rest" }, { signal: pause.signal, onSlice });
  expect(first.stop).toEqual({ reason: "budget" });
  const next = await engine.forward({ goal: "step" });
  expect(next.state.moment).toBe(first.state.moment + 1);
});

test("other requests are answered between two slices", async () => {
  const engine = await engineOf(endless);
  const pause = new AbortController();
  const walk = engine.walkForward({ goal: "rest" }, { signal: pause.signal, slice: 1000 });
  await engine.state(); // the walk has no end, but this has an answer
  pause.abort();
  expect((await walk).stop.reason).toBe("budget");
});
