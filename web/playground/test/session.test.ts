// The session of the page with a real `oncard`, without the page.

import { effect } from "@preact/signals";
import { afterAll, beforeAll, beforeEach, expect, onTestFinished, test, vi } from "vitest";

import { failingRun, isOnCard, showFailingRun } from "../src/interleaving/failing_run.js";
import { bench, present, session } from "../src/session/bench.js";
import { followSource, messages } from "../src/session/messages.js";
import { isEdited, ready, toggleBreakpoint } from "../src/session/on_card.js";
import { chooseOpening, closeRecord, openRecord, record } from "../src/session/record.js";
import { ownProgram } from "../src/store/own_program.js";
import { chooseSpeed, speeds } from "../src/store/settings.js";
import { edit, openLesson, source } from "../src/store/source.js";
import { stubStorage } from "./storage.js";

vi.mock("../src/session/engines.js", async () => {
  const { Engine } = await import("@oncard/engine");
  const { ChildProcessTransport } = await import("@oncard/engine/child-process");
  const { oncard } = await import("../../engine/test/support.js");
  const engine = new Engine(new ChildProcessTransport(oncard));
  return {
    startEngine: () => Promise.resolve(engine),
    fetchForRecords: () => Promise.resolve(false),
  };
});

const counting = "int x;\nint main()\n{\n  x = 1;\n  x = 2;\n}\n";
const unfinished = "int y;\nint main()\n{\n  y =\n}\n";
const finished = "int y;\nint main()\n{\n  y = 3;\n}\n";

function open(program: string): void {
  stubStorage();
  const files = { "program.c": program, "scenario.toml": 'program = "program.c"\n' };
  openLesson({ ...ownProgram, files });
}

const write = (program: string) => {
  edit("program.c", program);
};
const globals = () => present.globals.value.map(({ name }) => name);
const notice = () => session.notice.value.kind;
const moment = () => present.state.value?.moment;

beforeAll(() => {
  vi.stubGlobal("requestAnimationFrame", (draw: () => void) => setTimeout(draw, 0));
  chooseSpeed(Infinity);
  open(counting);
  followSource();
});

beforeEach(async () => {
  open(counting);
  await vi.waitFor(() => {
    expect([isEdited.value, notice(), globals(), moment()]).toEqual([false, "ready", ["x"], 0]);
  });
});

afterAll(async () => {
  (await bench.engine()).close();
  vi.unstubAllGlobals();
});

test("what is opened is on the card, before its first step", () => {
  expect(messages.diagnostics.value).toEqual([]);
  expect(session.listing.value.map(({ name }) => name)).toEqual(["main"]);
});

test("a choice that follows a failing run at once is not part of it", async () => {
  const { project } = source;
  await bench.stepStatement();
  const { schedule } = await (await bench.engine()).record();
  const threads = { reason: "", threads: [], skipped: 0, rows: [] };
  const shown = showFailingRun({ project: project.value, schedule, interleaving: threads });
  await Promise.all([shown, bench.goTo({ moment: 0 }), bench.stepThread(0)]);
  expect(failingRun.value?.schedule).toBe(schedule);
  expect(isOnCard.value).toBe(false);
});

test("an edit is loaded before the card has begun", async () => {
  write(finished);
  expect(isEdited.value).toBe(true);
  await vi.waitFor(() => {
    expect([isEdited.value, globals()]).toEqual([false, ["y"]]);
  });
});

test("an edit is not loaded over a card that has begun", async () => {
  await bench.stepStatement();
  const before = messages.diagnostics.value;
  write(finished);
  await vi.waitFor(() => {
    expect(messages.diagnostics.value).not.toBe(before);
  });
  expect([isEdited.value, globals()]).toEqual([true, ["x"]]);
  expect(await ready()).toBe(true);
  expect([isEdited.value, globals(), moment()]).toEqual([false, ["y"], 0]);
});

test("what is not finished leaves the card as it is", async () => {
  await bench.stepStatement();
  const before = moment();
  write(unfinished);
  await vi.waitFor(() => {
    expect(messages.diagnostics.value).not.toEqual([]);
  });
  expect(await ready()).toBe(false);
  expect([notice(), isEdited.value, globals()]).toEqual(["not-compiled", true, ["x"]]);
  expect(moment()).toBe(before);
  // The reader wanted to run it: it is loaded as soon as it compiles.
  write(finished);
  await vi.waitFor(() => {
    expect([notice(), isEdited.value, globals()]).toEqual(["ready", false, ["y"]]);
  });
});

test("another program that does not compile leaves nothing of the card", async () => {
  open(unfinished);
  await vi.waitFor(() => {
    expect([notice(), present.card.value, globals()]).toEqual(["not-compiled", undefined, []]);
  });
});

test("a run is brought to a moment, past a requirement that does not hold", async () => {
  edit("scenario.toml", 'program = "program.c"\nalways = ["x < 1"]\n');
  await vi.waitFor(() => {
    expect([isEdited.value, notice()]).toEqual([false, "ready"]);
  });
  await bench.runTo(2);
  expect(moment()).toBe(2);
  await bench.runTo(1_000_000);
  expect(session.notice.value).toMatchObject({ kind: "stopped", stop: { reason: "end" } });
  const end = moment();
  await bench.goTo({ moment: 0 });
  await bench.runTo(3);
  expect([moment(), end]).toEqual([3, present.state.value?.head]);
});

test("a run ends, and begins anew after the end", async () => {
  await bench.run();
  const end = moment();
  expect(notice()).toBe("stopped");
  expect(end).toBeGreaterThan(0);
  const moments: (number | undefined)[] = [];
  const stop = effect(() => {
    moments.push(moment());
  });
  await bench.run();
  stop();
  expect(moments.slice(0, 2)).toEqual([end, 0]);
  expect([notice(), moment()]).toEqual(["stopped", end]);
});

/** The axis travels 500 pulses after its thread has ended: 10 ms, 40 ms and 10 ms, from 0.25 ms on. */
const travelling =
  "TTrapPrm trap;\nint main()\n{\n  GT_PrfTrap(1);\n  trap.acc = 1;\n  trap.dec = 1;\n" +
  "  GT_SetTrapPrm(1, &trap);\n  GT_SetVel(1, 10);\n  GT_SetPos(1, 500);\n  GT_Update(1);\n}\n";

test.each(speeds)("a run at %d times the speed ends where the engine says", async (speed) => {
  chooseSpeed(speed);
  onTestFinished(() => {
    chooseSpeed(Infinity);
  });
  open(travelling);
  await vi.waitFor(() => {
    expect([isEdited.value, notice(), globals()]).toEqual([
      ...[false, "ready"],
      ["trap.acc", "trap.dec", "trap.velStart", "trap.smoothTime"],
    ]);
  });
  await bench.run();
  expect([notice(), present.state.value?.time_ms]).toEqual(["stopped", 60.25]);
});

test("a step back goes to the last statement at once, however long ago it was", async () => {
  open(travelling);
  await vi.waitFor(() => {
    expect([isEdited.value, notice(), globals()[0]]).toEqual([false, "ready", "trap.acc"]);
  });
  await bench.run();
  const executed = () => present.state.value?.threads[0]?.statements ?? 0;
  const all = executed();
  const engine = await bench.engine();
  const asked = [vi.spyOn(engine, "turns"), vi.spyOn(engine, "back"), vi.spyOn(engine, "goTo")];
  await bench.stepBack();
  expect([present.state.value?.next, executed()]).toEqual(["statement", all - 1]);
  expect(asked.reduce((sum, { mock }) => sum + mock.calls.length, 0)).toBeLessThan(5);
  await bench.stepBack();
  expect([present.state.value?.next, executed()]).toEqual(["statement", all - 2]);
});

test("breakpoints go to statements of what is loaded, and wait for what is edited", async () => {
  toggleBreakpoint(3);
  await vi.waitFor(() => {
    expect(session.breakpoints.value).toEqual([4]);
  });
  await bench.run();
  expect(session.notice.value).toMatchObject({ kind: "stopped", stop: { reason: "line" } });
  write(`\n${counting}`);
  toggleBreakpoint(4);
  expect(session.breakpoints.value).toEqual([]);
  toggleBreakpoint(3);
  expect(session.breakpoints.value).toEqual([3]);
  await ready();
  expect(session.breakpoints.value).toEqual([5]);
});

test("a run waits for a breakpoint that was just set", async () => {
  const engine = await bench.engine();
  const set = engine.setStops.bind(engine);
  const late = vi.spyOn(engine, "setStops").mockImplementation(async (wishes) => {
    await new Promise((resume) => setTimeout(resume, 100));
    return set(wishes);
  });
  toggleBreakpoint(5);
  await bench.run();
  late.mockRestore();
  expect(session.notice.value).toMatchObject({ kind: "stopped", stop: { reason: "line" } });
});

// --- Records of hosts ----------------------------------------------------------------------------

/** A host that opens a card twice and lets an axis jog; no card has its state at the end. */
const jogging = [
  { oncard: "host calls", format: 1 },
  ...[1, 2].flatMap(() => [
    { open: 0, bare: true, scenario: 'program = ""\ncard = "GE-400-PG"\naxes = 4\n' },
    ...[
      { call: "GT_AxisOn", in: [1] },
      { call: "GT_PrflV", in: [1] },
      { call: "GT_SetVel", in: [1, 10] },
      { call: "GT_SetAcc", in: [1, 1] },
      { call: "GT_Update", in: [1] },
    ].map((call, index) => ({ card: 0, us: 50 * (index + 1), ...call, code: 0 })),
    { close: 0, us: 20_000, hash: "0000000000000000" },
  ]),
]
  .map((line) => `${JSON.stringify(line)}\n`)
  .join("");

const host = () => present.state.value?.host;

test("a record is on the card instead of the program, call by call", async () => {
  await openRecord("jog.calls", jogging);
  expect(record.value).toMatchObject({ name: "jog.calls", chosen: 0, axes: 4 });
  expect([notice(), isEdited.value, globals()]).toEqual(["ready", false, []]);
  await bench.stepStatement();
  expect(host()).toMatchObject({ made: 1, last: "GT_AxisOn(1) = 0", next: "GT_PrflV(1)" });
  await bench.stepStatement();
  await bench.stepBack();
  expect(host()).toMatchObject({ made: 1 });
  // What is done to the editor does not touch the card.
  write(finished);
  expect(await ready()).toBe(true);
  expect(host()).toMatchObject({ made: 1 });
});

test("a record with another end than that of the card says so", async () => {
  await openRecord("jog.calls", jogging);
  await bench.run();
  expect(session.notice.value).toMatchObject({ kind: "stopped", stop: { reason: "deviation" } });
});

test("each opening of a card can be chosen", async () => {
  await openRecord("jog.calls", jogging);
  expect(record.value?.cards.map(({ opening }) => opening)).toEqual([1, 2]);
  await bench.stepStatement();
  await chooseOpening(1);
  expect([record.value?.chosen, host()?.made]).toEqual([1, 0]);
});

test("what is no record leaves the card as it is", async () => {
  await bench.stepStatement();
  const before = moment();
  await openRecord("text.calls", "this is no record");
  expect([notice(), record.value, globals(), moment()]).toEqual([
    "not-loaded",
    undefined,
    ["x"],
    before,
  ]);
});

test("the program comes back when the record is closed, and when another one is opened", async () => {
  await openRecord("jog.calls", jogging);
  await closeRecord();
  expect([record.value, isEdited.value, globals()]).toEqual([undefined, false, ["x"]]);
  await openRecord("jog.calls", jogging);
  open(finished);
  await vi.waitFor(() => {
    expect([record.value, isEdited.value, globals()]).toEqual([undefined, false, ["y"]]);
  });
});
