// The reader's choices, kept in this browser: language, colours, speed.

import { effect, signal } from "@preact/signals";
import { type Language, languageOf } from "@oncard/engine";

import { keep, kept } from "./keep.js";
import { isKeptSettings, type KeptSettings } from "./kept_schema.js";
import { salvaged } from "./salvaged.js";

export type Theme = NonNullable<KeptSettings["theme"]>;
/** The last one: as fast as it gets. */
export const speeds = [0.1, 1, 10, Infinity];

const before = salvaged(isKeptSettings, kept("settings")) ?? {};

export const language = signal<Language>(before.language ?? languageOf(navigator.language));
export const theme = signal<Theme>(before.theme ?? "system");
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
