// The colours and the font of a frame: those of the page.

import { channelColour, channelColours, token } from "../style/colours.js";

const names = [
  "ground",
  "surface",
  "ink",
  "muted",
  "line",
  "now",
  "now-line",
  "metal-2",
  "metal-3",
  "bed",
  "sans",
] as const;

export type Look = Readonly<Record<(typeof names)[number], string>> & {
  /** By their places. */
  channels: readonly string[];
};

/** As the page looks now. */
export function lookNow(): Look {
  const tokens = Object.fromEntries(names.map((name) => [name, token(`--${name}`)]));
  const channels = Array.from({ length: channelColours }, (_, index) => channelColour(index));
  return { ...(tokens as Record<(typeof names)[number], string>), channels };
}

export function channelOf({ channels }: Look, place: number): string {
  return channels[place % channels.length] ?? "";
}
