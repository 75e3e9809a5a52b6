// What this browser keeps. Where storage is refused (private windows, full disks) the page works
// on, and says that nothing is kept.
// Tested by test/keep.test.ts.

import { slice } from "./slice.js";

const [{ keeps }, change] = slice({ keeps: true });
/** False as soon as something could not be kept. */
export { keeps };

const prefix = "oncard.";

/** A kept value of JSON; undefined if there is none that can be read. */
export function kept(key: string): unknown {
  try {
    const text = localStorage.getItem(prefix + key);
    return text === null ? undefined : (JSON.parse(text) as unknown);
  } catch {
    return undefined;
  }
}

export function keep(key: string, value: unknown): void {
  try {
    localStorage.setItem(prefix + key, JSON.stringify(value));
    change({ keeps: true });
  } catch {
    change({ keeps: false });
  }
}

/** Tells what other tabs of this browser keep from now on. */
export function listenToOtherTabs(take: (key: string, value: unknown) => void): void {
  window.addEventListener("storage", ({ key, newValue }) => {
    if (!key?.startsWith(prefix) || newValue === null) return;
    const name = key.slice(prefix.length);
    take(name, kept(name));
  });
}
