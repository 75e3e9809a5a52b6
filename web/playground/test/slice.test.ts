import { computed, effect } from "@preact/signals";
import { expect, test } from "vitest";

import { slice } from "../src/store/slice.js";

test("a slice has its first values", () => {
  const [state] = slice({ a: 1, b: "x" as string | undefined });
  expect([state.a.value, state.b.value]).toEqual([1, "x"]);
});

test("what changes parts of a slice leaves the others as they are", () => {
  const [state, change] = slice<{ a: number; b: string | undefined }>({ a: 1, b: "x" });
  change({ a: 2 });
  expect([state.a.value, state.b.value]).toEqual([2, "x"]);
  change({ b: undefined });
  expect([state.a.value, state.b.value]).toEqual([2, undefined]);
});

test("several parts change at once for whoever follows them", () => {
  const [{ from, to }, change] = slice({ from: 0, to: 10 });
  const length = computed(() => to.value - from.value);
  const seen: number[] = [];
  effect(() => {
    seen.push(length.value);
  });
  change({ from: 10, to: 30 });
  expect(seen).toEqual([10, 20]);
});

test("only whoever has read a part is called when it changes", () => {
  const [{ a }, change] = slice({ a: 1, b: 1 });
  const seen: number[] = [];
  effect(() => {
    seen.push(a.value);
  });
  change({ b: 2 });
  change({ a: 1 });
  expect(seen).toEqual([1]);
});
