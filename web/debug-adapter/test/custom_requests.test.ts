import type { Card, Channel, LineWrites, State } from "@oncard/engine";
import { expect, test } from "vitest";

import { type Editor, openEditor, sample } from "./support.js";

interface Written {
  lines: (LineWrites & { path?: string })[];
  moment: number;
}

/** Stands at the end of a move of axis 1 by 50 000 pulses. */
async function afterMove(client: Record<string, unknown> = {}): Promise<Editor> {
  const editor = await openEditor();
  await editor.launch(sample("10_trap/trap.toml"), {}, client);
  await editor.run();
  return editor;
}

function ask(editor: Editor): Promise<{ card: Card; state: State }> {
  return editor.request("oncard.card");
}

async function inputs(editor: Editor): Promise<number | undefined> {
  const { card } = await ask(editor);
  return card.words.find(({ name }) => name === "gpi")?.value;
}

test("the card with its axes, and where the run is", async () => {
  const editor = await afterMove();
  const { card, state } = await ask(editor);
  const axes = card.parts.filter(({ part }) => part === "axis");
  expect(axes).toHaveLength(8);
  expect(axes[0]?.values).toContainEqual(
    expect.objectContaining({ path: "axis1.prfPos", value: 50_000, unit: "pulse" }),
  );
  expect(state.time_ms).toBeGreaterThan(1000);
  expect(state.moment).toBe(state.head);
});

test("the way of an axis up to now", async () => {
  const editor = await afterMove();
  const { state } = await ask(editor);
  const names = ["axis1.prfPos"];
  const args = { names, from_ms: 0, to_ms: state.time_ms, points: 10 };
  const { channels } = await editor.request<{ channels: Channel[] }>("oncard.trace", args);
  const [way] = channels;
  expect(way).toMatchObject({ name: "axis1.prfPos" });
  expect(way?.least[0]).toBe(0);
  expect(way?.largest.at(-1)).toBe(50_000);
});

test("an input is switched, and the variables of the editor are told", async () => {
  const editor = await afterMove({ supportsInvalidatedEvent: true });
  expect(await inputs(editor)).toBe(0);
  const told = editor.client.waitForEvent("invalidated");
  await editor.request("oncard.setInput", { type: "gpi", index: 3, level: 1 });
  expect(await told).toMatchObject({ body: { areas: ["variables"] } });
  // The card sees it after its filter.
  for (let cycle = 0; cycle < 5; ++cycle) {
    await editor.console("cycle");
    await editor.stopped();
  }
  expect(await inputs(editor)).toBe(0b100);
});

test("what lines have written, with the paths of their files", async () => {
  const editor = await openEditor();
  const program = sample("01_sum/sum.c");
  await editor.launch(sample("01_sum/one_thread.toml"));
  await editor.run();
  const { lines, moment } = await editor.request<Written>("oncard.written");
  const added = lines.find(({ values }) => values.some(({ name }) => name === "sum"));
  // GTS manual, example 10-1: 1 + 2 + ... + 100.
  expect(added).toMatchObject({ path: program, values: [{ name: "sum", value: 5050 }] });
  expect(moment).toBeGreaterThan(added?.moment ?? Infinity);
});

test("the engine says what is wrong", async () => {
  const editor = await afterMove();
  const none = { type: "gpi", index: 99, level: 1 };
  await expect(editor.request("oncard.setInput", none)).rejects.toThrow(
    "'index' is wrong: an integer from 1 to 16",
  );
  await expect(editor.request("oncard.trace")).rejects.toThrow("names");
  await expect(editor.request("oncard.picture")).rejects.toThrow("unrecognized request");
});

test("without a program there is no card", async () => {
  const editor = await openEditor();
  await editor.initialize();
  await expect(ask(editor)).rejects.toThrow("nothing has been launched");
});
