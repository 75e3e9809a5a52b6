import { afterEach, expect, test, vi } from "vitest";

import {
  changeSpeed,
  chooseLanguage,
  chooseSpeed,
  fastest,
  chooseTheme,
  chooseUnit,
  keepSettings,
  placeOfSpeed,
  settings,
  slowest,
  speedAt,
} from "../src/store/settings.js";
import { stubStorage } from "./storage.js";

afterEach(() => {
  vi.unstubAllGlobals();
});

function now(): unknown[] {
  return [settings.language.value, settings.theme.value, settings.speed.value];
}

test.each([
  ["nothing", undefined, "zh-CN", ["zh", "system", 1]],
  ["everything", { language: "en", theme: "dark", speed: 10 }, "zh-CN", ["en", "dark", 10]],
  ["the highest speed", { speed: 0 }, "en-US", ["en", "system", Infinity]],
  ["what no version knows", { language: "fr", theme: 1, speed: 1001 }, "de", ["en", "system", 1]],
])("the settings after %s was kept", (_, kept, browserLanguage, expected) => {
  stubStorage({ settings: kept });
  keepSettings(browserLanguage);
  expect(now()).toEqual(expected);
});

test("what is chosen is kept", () => {
  const storage = stubStorage();
  keepSettings("en");
  chooseLanguage("zh");
  chooseTheme("light");
  chooseSpeed(Infinity);
  expect(JSON.parse(storage.get("oncard.settings") ?? "")).toEqual({
    ...{ language: "zh", theme: "light", speed: 0 },
  });
});

test("the unit of the timeline is kept once it is chosen", () => {
  const storage = stubStorage({ settings: { unit: "hours" } });
  keepSettings("en");
  expect(settings.unit.value).toBe(undefined);
  chooseUnit("ms");
  expect(JSON.parse(storage.get("oncard.settings") ?? "")).toMatchObject({ unit: "ms" });
  keepSettings("en");
  expect(settings.unit.value).toBe("ms");
});

test("the speed changes by steps, and ends at the last ones", () => {
  chooseSpeed(1);
  changeSpeed(-1);
  expect(settings.speed.value).toBe(0.1);
  changeSpeed(-1);
  expect(settings.speed.value).toBe(0.1);
  chooseSpeed(10);
  changeSpeed(1);
  changeSpeed(1);
  expect(settings.speed.value).toBe(Infinity);
});

test.each([
  [slowest, 0.01],
  [-10, 0.1],
  [-9, 0.13],
  [0, 1],
  [5, 3.2],
  [10, 10],
  [fastest - 1, 1000],
  [fastest, Infinity],
])("the place %d of the slider is %d times the speed", (place, speed) => {
  expect(speedAt(place)).toBe(speed);
  expect(placeOfSpeed(speed)).toBe(place);
});

test("keys lead from a speed between the marks to the next mark", () => {
  chooseSpeed(3.2);
  changeSpeed(1);
  expect(settings.speed.value).toBe(10);
  chooseSpeed(0.32);
  changeSpeed(-1);
  expect(settings.speed.value).toBe(0.1);
  chooseSpeed(1000);
  changeSpeed(1);
  expect(settings.speed.value).toBe(Infinity);
});
