// The panels of the page, and the one of them that narrow screens show.

import { signal } from "@preact/signals";

export const panels = ["lesson", "program", "machine", "timeline", "scope", "values"] as const;
export type Panel = (typeof panels)[number];

export const front = signal<Panel>("lesson");
