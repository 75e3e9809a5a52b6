import { afterEach, expect, test, vi } from "vitest";

import { keepPlaces, resetWidth, resetWidths, widen, widthsOf } from "../src/store/places.js";
import { stubStorage } from "./storage.js";

afterEach(() => {
  vi.unstubAllGlobals();
});

test("each layout has its widths", () => {
  stubStorage();
  keepPlaces();
  widen("motion", "left", 0.2);
  widen("motion", "right", 0.5);
  widen("threads", "right", 0.4);
  expect(widthsOf("motion")).toEqual({ left: 0.2, right: 0.5 });
  expect(widthsOf("threads")).toEqual({ right: 0.4 });
  expect(widthsOf("language")).toEqual({});
});

test("a column, or all of a layout, become as wide as they were", () => {
  stubStorage({ places: { motion: { left: 0.2, right: 0.5 }, threads: { right: 0.4 } } });
  keepPlaces();
  resetWidth("motion", "left");
  expect(widthsOf("motion")).toEqual({ right: 0.5 });
  resetWidths("motion");
  expect(widthsOf("motion")).toEqual({});
  expect(widthsOf("threads")).toEqual({ right: 0.4 });
});

test("what is chosen is kept, and what no version writes is left out", () => {
  const storage = stubStorage({ places: { motion: { left: 0.2, right: 7 }, threads: "wide" } });
  keepPlaces();
  expect(widthsOf("motion")).toEqual({ left: 0.2 });
  widen("usual", "left", 0.25);
  expect(JSON.parse(storage.get("oncard.places") ?? "")).toEqual({
    ...{ motion: { left: 0.2 }, usual: { left: 0.25 } },
  });
});
