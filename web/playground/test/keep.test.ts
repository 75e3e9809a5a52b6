import { afterEach, expect, test, vi } from "vitest";

import { keep, keeps, kept } from "../src/store/keep.js";

afterEach(() => {
  vi.unstubAllGlobals();
});

function storage(): Map<string, string> {
  const map = new Map<string, string>();
  vi.stubGlobal("localStorage", {
    getItem: (key: string) => map.get(key) ?? null,
    setItem: (key: string, text: string) => map.set(key, text),
  });
  return map;
}

test("what is kept can be read", () => {
  const map = storage();
  keep("shelf.a", { open: 1 });
  expect([...map.keys()]).toEqual(["oncard.shelf.a"]);
  expect(kept("shelf.a")).toEqual({ open: 1 });
  expect(kept("shelf.b")).toBeUndefined();
});

test("what something else has written is nothing", () => {
  storage().set("oncard.shelf.a", "{");
  expect(kept("shelf.a")).toBeUndefined();
});

test("a browser that keeps nothing is noticed", () => {
  const refuse = () => {
    throw new Error("denied");
  };
  vi.stubGlobal("localStorage", { getItem: refuse, setItem: refuse });
  keep("a", 1);
  expect(keeps.value).toBe(false);
  expect(kept("a")).toBeUndefined();
  storage();
  keep("a", 1);
  expect(keeps.value).toBe(true);
});
