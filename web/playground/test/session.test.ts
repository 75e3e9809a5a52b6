// The session of the page with a real `oncard`, without the page.

import { effect } from "@preact/signals";
import { afterAll, beforeAll, beforeEach, expect, test, vi } from "vitest";

import { bench, present, session } from "../src/session/bench.js";
import { followSource, messages } from "../src/session/messages.js";
import { isEdited, ready, toggleBreakpoint } from "../src/session/on_card.js";
import { ownProgram } from "../src/store/own_program.js";
import { chooseSpeed } from "../src/store/settings.js";
import { edit, openLesson } from "../src/store/source.js";
import { stubStorage } from "./storage.js";

vi.mock("../src/session/engines.js", async () => {
  const { Engine } = await import("@oncard/engine");
  const { ChildProcessTransport } = await import("@oncard/engine/child-process");
  const { oncard } = await import("../../engine/test/support.js");
  const engine = new Engine(new ChildProcessTransport(oncard));
  return { startEngine: () => Promise.resolve(engine) };
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
