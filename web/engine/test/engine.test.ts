import { Engine, RefusedError } from "@oncard/engine";
import { expect, test } from "vitest";

import { engineOf, sample, ScriptedTransport, startEngine } from "./support.js";

const counter = "int x;\nint f()\n{\n  x = 1;\n  x = 2;\n  return x;\n}\n";

test("there is a method for every request of the protocol", async () => {
  const { requests } = await startEngine().hello();
  const methods = Object.keys(requests).map((name) =>
    name.replace(/_(\w)/g, (_, letter: string) => letter.toUpperCase()),
  );
  expect(Object.getOwnPropertyNames(Engine.prototype).sort()).toEqual(
    [...methods, "constructor", "close", "explore", "walkForward", "walkBack"].sort(),
  );
});

test("the language is that of the engine's texts", async () => {
  const engine = startEngine();
  await engine.hello("zh");
  await expect(engine.state()).rejects.toThrow("尚未加载程序");
});

test("a project can bring its files", async () => {
  const engine = startEngine();
  const loaded = await engine.load({
    main: "two.toml",
    files: { "two.toml": 'program = "p.c"\n[[thread]]\nfunction = "f"\n', "p.c": counter },
  });
  expect(loaded).toMatchObject({ compiled: true, files: [{ path: "p.c", text: counter }] });
});

test("a program with an error is not loaded", async () => {
  const engine = startEngine();
  const project = { main: "p.c", files: { "p.c": "int f()\n{\n  y = 1;\n}\n" } };
  const error = { code: "MP027", severity: "error", file: "p.c", line: 3 };
  expect(await engine.load(project)).toMatchObject({ compiled: false, diagnostics: [error] });
  expect(await engine.check(project)).toMatchObject({ compiled: false, diagnostics: [error] });
  await expect(engine.state()).rejects.toThrow(RefusedError);
});

test("structured C is compiled when asked for", async () => {
  const files = { "p.c": "int x;\nint f()\n{\n  while (x < 3) {\n    x = x + 1;\n  }\n}\n" };
  const engine = startEngine();
  expect(await engine.check({ main: "p.c", files })).toMatchObject({ compiled: false });
  expect(await engine.check({ main: "p.c", files, structured: true })).toMatchObject({
    compiled: true,
  });
});

test("a whole run does not touch the session", async () => {
  const engine = await engineOf(counter);
  const { run } = await engine.run({ main: sample("01_sum/two_threads.toml") }, ["sum"]);
  expect(run).toMatchObject({ passed: true, end: "quiet", values: { sum: 5050 } });
  expect((await engine.state()).moment).toBe(0);
});

test("steps and moments", async () => {
  const engine = await engineOf(counter);
  expect((await engine.forward({ goal: "step" })).state).toMatchObject({ moment: 1, cycle: 1 });
  expect((await engine.stepThread(0)).state).toMatchObject({ moment: 2, statements: 1 });
  expect((await engine.back({ goal: "step" })).state).toMatchObject({ moment: 1, head: 2 });
  expect(await engine.goTo({ moment: 2 })).toMatchObject({ moment: 2 });
  expect(await engine.goTo({ ms: 0 })).toMatchObject({ moment: 0 });
});

test("variables, values and changes", async () => {
  const engine = await engineOf("int a[2];\nint f()\n{\n  int b;\n  b = 7;\n  a[1] = b;\n}\n");
  await engine.walkForward({ goal: "stop" });
  const a = { name: "a", path: "a", type: "int", slot: 0, value: [0, 7] };
  expect(await engine.variables()).toEqual([a]);
  expect(await engine.variables(0)).toMatchObject([{ name: "b", path: "page0.b", value: 7 }]);
  expect(await engine.evaluate("a[1]")).toEqual({ value: 7, path: "a[1]" });
  expect(await engine.evaluate("a[1] > 7")).toEqual({ holds: false });
  await engine.write("a[1]", 9);
  expect(await engine.evaluate("a")).toEqual({ value: [0, 9], path: "a" });
  expect((await engine.slots(0)).slice(0, 2)).toEqual(BigInt64Array.of(7n, 0n));
});

test("the card, its inputs and voltages", async () => {
  const engine = await engineOf(counter);
  await engine.setInput("gpi", 3, 1);
  await engine.setVoltage(2, 1.5);
  await engine.walkForward({ goal: "time", ms: 10 });
  const { parts, words } = await engine.card();
  expect(words.find(({ name }) => name === "gpi")).toMatchObject({ value: 0b100, pins: 16 });
  const adc = parts.find(({ part, number }) => part === "adc" && number === 2);
  expect(adc?.values.find(({ name }) => name === "volts")?.value).toBeCloseTo(1.5, 2);
});

test("values over time, turns, states, the listing and a recording", async () => {
  const engine = await engineOf(counter);
  await engine.walkForward({ goal: "stop" });
  const channel = { name: "x", least: [0], largest: [2] };
  expect(await engine.trace(["x"], 0, 1, 1)).toEqual([channel]);
  expect(await engine.turns(0, 4)).toMatchObject([{ thread: 0, statements: 3 }]);
  expect(await engine.spans()).toMatchObject([
    { thread: 0, state: "running", from: 0, to: 4 },
    { thread: 0, state: "finished", from: 4, to: 4 },
  ]);
  expect(await engine.listing()).toMatchObject([{ name: "f", statements: [{ line: 4 }, {}, {}] }]);
  expect((await engine.record()).schedule).toMatch(/^oncard-schedule 1\n/);
});

test("stops and lines of the log", async () => {
  const engine = await engineOf(counter);
  const log: unknown[] = [];
  engine.onLog = (event) => log.push(event);
  const lines = [{ line: 5, log: "x is {x}" }, { line: 1 }];
  expect(await engine.setStops({ lines })).toEqual({ lines: [5, 4] });
  const { stop } = await engine.forward({ goal: "stop" });
  expect(stop).toEqual({ reason: "line", thread: 0, number: 1 });
  await engine.forward({ goal: "stop" });
  expect(log).toEqual([{ event: "log", moment: 2, thread: 0, text: "x is 1" }]);
});

test("requests are answered in their order", async () => {
  const engine = await engineOf(counter);
  const order: string[] = [];
  await Promise.all([
    engine.forward({ goal: "step" }).then(() => order.push("forward")),
    engine.state().then(({ moment }) => order.push(`at ${moment}`)),
    engine.back({ goal: "step" }).then(() => order.push("back")),
  ]);
  expect(order).toEqual(["forward", "at 1", "back"]);
});

test("slots keep all of their 64 bits", async () => {
  const answer = '{"id":1,"ok":true,"result":[9223372036854775807,-9007199254740993]}';
  const engine = new Engine(new ScriptedTransport([answer]));
  expect(await engine.slots(0)).toEqual(BigInt64Array.of(9223372036854775807n, -9007199254740993n));
});

test("missing arguments are not sent", async () => {
  const transport = new ScriptedTransport(['{"id":1,"ok":true,"result":[]}']);
  await new Engine(transport).variables();
  expect(transport.sent).toEqual(['{"id":1,"request":"variables","arguments":{}}']);
});

test("an engine that talks of something else is ended", async () => {
  const engine = new Engine(new ScriptedTransport(["Usage: oncard"]));
  const ended: string[] = [];
  engine.onEnded = ({ message }) => ended.push(message);
  await expect(engine.state()).rejects.toThrow(/not an answer.*Usage: oncard/);
  expect(ended).toHaveLength(1);
  await expect(engine.state()).rejects.toThrow(/not an answer/);
});

test("requests that are not answered fail when a session is closed", async () => {
  const engine = new Engine(new ScriptedTransport([]));
  const state = engine.state();
  engine.close();
  await expect(state).rejects.toThrow("the session was closed");
});
