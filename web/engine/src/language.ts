// The language of the texts of an engine.
// Tested by test/language.test.ts.

import type { Language } from "./protocol.js";

/** The language for a locale such as `zh-cn`. */
export function languageOf(locale: string | undefined): Language {
  return locale?.toLowerCase().startsWith("zh") ? "zh" : "en";
}
