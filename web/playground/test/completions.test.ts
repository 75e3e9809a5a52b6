import { EditorState } from "@codemirror/state";
import { expect, test, vi } from "vitest";

import { type Complete, completionAt } from "../src/editor/completions.js";

const words = [
  { label: "GT_SetVel", kind: "command" as const, detail: "short GT_SetVel(short, double)" },
  { label: "GT_SetPos", kind: "command" as const, insert: "GT_SetPos(" },
];

/** What is offered at the end of a text. */
function offered(doc: string, explicit = false) {
  const complete = vi.fn<Complete>((to) => Promise.resolve({ from: 0, to, words }));
  const state = EditorState.create({ doc });
  return { complete, result: completionAt({ state, pos: doc.length, explicit }, complete) };
}

test("words are offered in the order of the engine, with what they insert", async () => {
  const result = await offered("GT_S").result;
  expect(result).toMatchObject({ from: 0, to: 4 });
  const options = result?.options ?? [];
  expect(options.map(({ label, apply }) => [label, apply])).toEqual([
    ["GT_SetVel", "GT_SetVel"],
    ["GT_SetPos", "GT_SetPos("],
  ]);
  expect(options[0]?.boost).toBeGreaterThan(options[1]?.boost ?? 0);
  expect(options[0]?.detail).toBe("short GT_SetVel(short, double)");
});

test.each(["", "x ", "x = 1;", "x = .", "(", "a\n"])("nobody is asked behind '%s'", async (doc) => {
  const { complete, result } = offered(doc);
  expect(await result).toBeNull();
  expect(complete).not.toHaveBeenCalled();
});

test.each(["x", "GT_", "trap.", "#", "&", "int x"])(
  "words are offered behind '%s'",
  async (doc) => {
    expect(await offered(doc).result).not.toBeNull();
  },
);

test("a wish is asked about any place", async () => {
  expect(await offered("x = ", true).result).not.toBeNull();
});

test("nothing is offered where the engine knows nothing", async () => {
  const state = EditorState.create({ doc: "x" });
  const at = { state, pos: 1, explicit: true };
  expect(await completionAt(at, () => Promise.resolve(undefined))).toBeNull();
  const none = { from: 0, to: 1, words: [] };
  expect(await completionAt(at, () => Promise.resolve(none))).toBeNull();
});
