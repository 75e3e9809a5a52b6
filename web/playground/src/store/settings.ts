// The reader's choices, kept in this browser: language, colours, speed.

import { effect, signal } from "@preact/signals";
import { type Language, languageOf } from "@oncard/engine";

import { keep, kept } from "./keep.js";

export type Theme = "system" | "light" | "dark";
/** The last one: as fast as it gets. */
export const speeds = [0.1, 1, 10, Infinity];

interface Settings {
  language?: Language;
  theme?: Theme;
  speed?: number;
}

const stored = kept("settings");
const before: Settings = typeof stored === "object" && stored !== null ? stored : {};

export const language = signal<Language>(
  before.language === "en" || before.language === "zh"
    ? before.language
    : languageOf(navigator.language),
);
export const theme = signal<Theme>(
  before.theme === "light" || before.theme === "dark" ? before.theme : "system",
);
/** Times of the card for one of the reader's; JSON knows no Infinity, so that is kept as 0. */
export const speed = signal<number>(
  before.speed === 0 ? Infinity : (speeds.find((each) => each === before.speed) ?? 1),
);

const systemIsDark = matchMedia("(prefers-color-scheme: dark)");
const dark = signal(systemIsDark.matches);
systemIsDark.addEventListener("change", ({ matches }) => {
  dark.value = matches;
});

/** The colours that are shown. */
export function isDark(): boolean {
  return theme.value === "system" ? dark.value : theme.value === "dark";
}

/** Keeps the settings, and applies them to the document. */
export function applySettings(): void {
  effect(() => {
    const speedKept = speed.value === Infinity ? 0 : speed.value;
    keep("settings", { language: language.value, theme: theme.value, speed: speedKept });
    document.documentElement.lang = language.value === "zh" ? "zh-CN" : "en";
    document.documentElement.dataset["theme"] = isDark() ? "dark" : "light";
  });
}
