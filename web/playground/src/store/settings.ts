// The reader's choices, kept in this browser: language, colours, speed, unit of the timeline.
// Tested by test/settings.test.ts.

import { type Language, languageOf } from "@oncard/engine";
import { effect, signal } from "@preact/signals";

import { keep, kept } from "./keep.js";
import { isKeptSettings, type KeptSettings } from "./kept_schema.js";
import { salvaged } from "./salvaged.js";
import { slice } from "./slice.js";

/** In what the timeline counts. */
export const units = ["ms", "moments"] as const;
export type Unit = (typeof units)[number];
export const themes = ["system", "light", "dark"] as const;
export type Theme = (typeof themes)[number];
/** Those that have a mark of their own, and to which keys lead. The last one: as fast as it gets. */
export const speeds = [0.1, 1, 10, Infinity];
/** Places of the slider, in tenths of a decade; beyond the last speed it is as fast as it gets. */
export const slowest = -20;
export const fastest = 31;

interface Settings {
  language: Language;
  theme: Theme;
  /** Times of the card for one of the reader's. */
  speed: number;
  /** In what the timeline counts; undefined: as the lesson wants it. */
  unit: Unit | undefined;
}

const [settings, change] = slice<Settings>({
  language: "en",
  theme: "system",
  speed: 1,
  unit: undefined,
});
export { settings };

export function chooseLanguage(language: Language): void {
  change({ language });
}

export function chooseTheme(theme: Theme): void {
  change({ theme });
}

export function chooseSpeed(speed: number): void {
  change({ speed });
}

export function chooseUnit(unit: Unit): void {
  change({ unit });
}

/** What the slider shows is rounded to two figures. */
export function speedAt(place: number): number {
  return place >= fastest ? Infinity : Number((10 ** (place / 10)).toPrecision(2));
}

export function placeOfSpeed(speed: number): number {
  return speed === Infinity ? fastest : Math.round(10 * Math.log10(speed));
}

/** To the next faster or slower speed that has a mark, if there is one. */
export function changeSpeed(by: 1 | -1): void {
  const now = settings.speed.peek();
  const next =
    by > 0 ? speeds.find((each) => each > now) : speeds.filter((each) => each < now).at(-1);
  change({ speed: next ?? now });
}

// --- Keeping -------------------------------------------------------------------------------------

/** JSON knows no Infinity, so that is kept as 0. */
function speedOf(stored = 1): number {
  if (stored === 0) return Infinity;
  return stored >= speedAt(slowest) && stored <= speedAt(fastest - 1) ? stored : 1;
}

/**
 * Takes the settings that were kept, and keeps what is chosen from now on.
 * @param browserLanguage if none was chosen
 */
export function keepSettings(browserLanguage: string): void {
  const before: KeptSettings = salvaged(isKeptSettings, kept("settings")) ?? {};
  change({
    language: before.language ?? languageOf(browserLanguage),
    theme: before.theme ?? "system",
    speed: speedOf(before.speed),
    unit: before.unit,
  });
  effect(() => {
    const { language, theme, speed, unit } = settings;
    const now: KeptSettings = {
      language: language.value,
      theme: theme.value,
      speed: speed.value === Infinity ? 0 : speed.value,
    };
    keep("settings", unit.value ? { ...now, unit: unit.value } : now);
  });
}

// --- The document --------------------------------------------------------------------------------

const systemIsDark = signal(false);

/** The colours that are shown. */
export function isDark(): boolean {
  const { theme } = settings;
  return theme.value === "system" ? systemIsDark.value : theme.value === "dark";
}

/** Applies the settings to the document. */
export function applySettings(): void {
  const system = matchMedia("(prefers-color-scheme: dark)");
  systemIsDark.value = system.matches;
  system.addEventListener("change", ({ matches }) => {
    systemIsDark.value = matches;
  });
  effect(() => {
    document.documentElement.lang = settings.language.value === "zh" ? "zh-CN" : "en";
    document.documentElement.dataset["theme"] = isDark() ? "dark" : "light";
  });
}
