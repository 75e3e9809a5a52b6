import { afterEach, expect, test, vi } from "vitest";

import { keep, keeps, kept } from "../src/store/keep.js";
import { stubStorage } from "./storage.js";

afterEach(() => {
  vi.unstubAllGlobals();
});

test("what is kept can be read", () => {
  const map = stubStorage();
  keep("shelf.a", { open: 1 });
  expect([...map.keys()]).toEqual(["oncard.shelf.a"]);
  expect(kept("shelf.a")).toEqual({ open: 1 });
  expect(kept("shelf.b")).toBeUndefined();
});

test("what something else has written is nothing", () => {
  stubStorage().set("oncard.shelf.a", "{");
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
  stubStorage();
  keep("a", 1);
  expect(keeps.value).toBe(true);
});
