// A card for tests that care for some of its members.

import type { Card } from "@oncard/engine";

export function cardWith(members: Partial<Card>): Card {
  const view = { title: "", kind: "auto", x: 1, y: 2, z: 0, turn: 10_000, pins: [] } as const;
  return { parts: [], words: [], switches: [], paths: [], view: { ...view, pins: [] }, ...members };
}
