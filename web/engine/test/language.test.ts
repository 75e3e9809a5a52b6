import { expect, test } from "vitest";

import { languageOf } from "../src/language.js";

test.each([
  ["zh", "zh"],
  ["zh-CN", "zh"],
  ["ZH_tw", "zh"],
  ["en-US", "en"],
  ["de", "en"],
  ["", "en"],
  [undefined, "en"],
])("%j: %s", (locale, language) => {
  expect(languageOf(locale)).toBe(language);
});
