// The server's own words, in the language of the editor. What the engine says comes in that language
// by itself.

import type { Language } from "@oncard/engine";

export interface Words {
  /** The title of a correction that inserts these texts. */
  fix(texts: readonly string[]): string;
  fixAll: string;
}

const english: Words = {
  fix: (texts) => {
    const shown = shownText(texts);
    return shown === "" ? "remove it" : `change to '${shown}'`;
  },
  fixAll: "correct everything that oncard can correct",
};

const chinese: Words = {
  fix: (texts) => {
    const shown = shownText(texts);
    return shown === "" ? "删除" : `改为“${shown}”`;
  },
  fixAll: "改正 oncard 能改正的所有问题",
};

export function wordsIn(language: Language): Words {
  return language === "zh" ? chinese : english;
}

/** Short enough for a menu. */
function shownText(texts: readonly string[]): string {
  const text = texts.join(" … ").replace(/\s+/g, " ").trim();
  return text.length > 40 ? `${text.slice(0, 39)}…` : text;
}
