import { afterEach, expect, test, vi } from "vitest";

import { columns } from "../src/store/arrangement.js";
import {
  closeColumn,
  closedIn,
  fillWith,
  heighten,
  keepPlaces,
  openColumn,
  placesOf,
  resetPlaces,
  widen,
} from "../src/store/places.js";
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
  expect(placesOf("motion")).toEqual({ left: 0.2, right: 0.5 });
  expect(placesOf("threads")).toEqual({ right: 0.4 });
  expect(placesOf("language")).toEqual({});
});

test("a column, or all of a layout, become as wide as they were", () => {
  stubStorage({ places: { motion: { left: 0.2, right: 0.5 }, threads: { right: 0.4 } } });
  keepPlaces();
  widen("motion", "left", undefined);
  expect(placesOf("motion")).toEqual({ right: 0.5 });
  resetPlaces("motion");
  expect(placesOf("motion")).toEqual({});
  expect(placesOf("threads")).toEqual({ right: 0.4 });
});

test("what is chosen is kept, and what no version writes is left out", () => {
  const storage = stubStorage({ places: { motion: { left: 0.2, right: 7 }, threads: "wide" } });
  keepPlaces();
  expect(placesOf("motion")).toEqual({ left: 0.2 });
  widen("usual", "left", 0.25);
  expect(JSON.parse(storage.get("oncard.places") ?? "")).toEqual({
    ...{ motion: { left: 0.2 }, usual: { left: 0.25 } },
  });
});

test("a panel of each layout may fill the page, until it is left", () => {
  const storage = stubStorage({ places: { threads: { whole: "lesson", left: 0.2 } } });
  keepPlaces();
  expect(placesOf("threads")).toEqual({ left: 0.2 });
  fillWith("motion", "scope");
  expect(placesOf("motion")).toEqual({ whole: "scope" });
  expect(placesOf("threads")).toEqual({ left: 0.2 });
  fillWith("motion", undefined);
  expect(JSON.parse(storage.get("oncard.places") ?? "")).toEqual({
    ...{ threads: { left: 0.2 }, motion: {} },
  });
});

test("a panel is as high as the reader makes it, in each layout", () => {
  const storage = stubStorage({ places: { threads: { heights: { machine: 0.3, scope: 2 } } } });
  keepPlaces();
  expect(placesOf("threads")).toEqual({ heights: { machine: 0.3 } });
  heighten("threads", "timeline", 0.2);
  expect(placesOf("threads")).toEqual({ heights: { machine: 0.3, timeline: 0.2 } });
  heighten("threads", "machine", undefined);
  heighten("motion", "scope", 0.5);
  expect(JSON.parse(storage.get("oncard.places") ?? "")).toEqual({
    ...{ threads: { heights: { timeline: 0.2 } }, motion: { heights: { scope: 0.5 } } },
  });
  heighten("motion", "scope", undefined);
  expect(placesOf("motion")).toEqual({});
});

test("columns of each layout are closed until they are opened", () => {
  const storage = stubStorage({ places: { motion: { left: 0.2 } } });
  keepPlaces();
  expect(closedIn("motion")).toEqual([]);
  closeColumn("motion", "right");
  closeColumn("motion", "left");
  closeColumn("threads", "middle");
  expect(closedIn("motion")).toEqual(["left", "right"]);
  openColumn("motion", "right");
  expect(JSON.parse(storage.get("oncard.places") ?? "")).toEqual({
    ...{ motion: { left: 0.2, closed: ["left"] }, threads: { closed: ["middle"] } },
  });
  openColumn("motion", "left");
  expect(placesOf("motion")).toEqual({ left: 0.2 });
  resetPlaces("threads");
  expect(closedIn("threads")).toEqual([]);
});

test("the guide of a free program is closed until it is opened", () => {
  const storage = stubStorage();
  keepPlaces();
  expect(closedIn("free")).toEqual(["left"]);
  openColumn("free", "left");
  expect(closedIn("free")).toEqual([]);
  expect(JSON.parse(storage.get("oncard.places") ?? "")).toEqual({ free: { closed: [] } });
  closeColumn("free", "left");
  expect(placesOf("free")).toEqual({});
  openColumn("free", "left");
  resetPlaces("free");
  expect(closedIn("free")).toEqual(["left"]);
});

test("what is open already stays as it was", () => {
  stubStorage();
  keepPlaces();
  openColumn("motion", "left");
  expect(placesOf("motion")).toEqual({});
  closeColumn("motion", "left");
  closeColumn("motion", "left");
  expect(closedIn("motion")).toEqual(["left"]);
});

test("the last column that is open stays open", () => {
  stubStorage();
  keepPlaces();
  for (const column of columns) closeColumn("motion", column);
  expect(closedIn("motion")).toEqual(["left", "middle"]);
});

test.each([
  ["a column that is not known", ["left", "top"], ["left"]],
  ["all columns", ["left", "middle", "right"], []],
  ["a text", "left", []],
])("%s among the closed ones: what is right of it is kept", (_, closed, right) => {
  stubStorage({ places: { motion: { left: 0.2, closed } } });
  keepPlaces();
  expect(closedIn("motion")).toEqual(right);
  expect(placesOf("motion").left).toBe(0.2);
});
