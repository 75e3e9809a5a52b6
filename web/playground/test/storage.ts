// A browser's storage for tests.

import { vi } from "vitest";

/** What the page keeps from now on, by its keys. */
export function stubStorage(kept: Record<string, unknown> = {}): Map<string, string> {
  const map = new Map(
    Object.entries(kept).map(([key, value]) => [`oncard.${key}`, JSON.stringify(value)]),
  );
  vi.stubGlobal("localStorage", {
    getItem: (key: string) => map.get(key) ?? null,
    setItem: (key: string, text: string) => map.set(key, text),
  });
  return map;
}
