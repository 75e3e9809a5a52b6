import { afterEach, expect, test, vi } from "vitest";

import {
  changeSpeed,
  chooseLanguage,
  chooseSpeed,
  chooseTheme,
  chooseUnit,
  keepSettings,
  settings,
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
  ["what no version knows", { language: "fr", theme: 1, speed: 3 }, "de", ["en", "system", 1]],
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
