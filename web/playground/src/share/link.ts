// Links that carry a whole project in the fragment of their address: `#p1=` and compressed JSON.
// The digit is the version. Nothing in a link is trusted.
// Tested by test/link.test.ts.

import { checked, type Lesson, type Mistake, missingFiles, parseLesson } from "@oncard/lessons";
import lzString from "lz-string";

import { isLinkContent, type LinkContent } from "./link_schema.js";
import { unpackedLength } from "./unpacked_length.js";

export interface Shared extends Omit<LinkContent, "own"> {
  own?: Lesson;
}

export type ReadLink =
  | { kind: "none" }
  | { kind: "lesson"; id: string }
  | { kind: "shared"; shared: Shared }
  | { kind: "newer"; version: number }
  | { kind: "foreign" }
  | { kind: "broken"; mistakes: Mistake[] };

/** Longer fragments are not read; they could not hold a project either. */
const longest = 2_000_000;
/** Nor could longer texts: two times all files of a lesson, every character as `\u0000`. */
const longestUnpacked = 16_000_000;

export function writeLink(shared: Shared): string {
  return `#p1=${lzString.compressToEncodedURIComponent(JSON.stringify(shared))}`;
}

export function lessonLink(id: string): string {
  return `#lesson=${id}`;
}

/** Reads the fragment of an address, with its `#`. */
export function readLink(fragment: string): ReadLink {
  if (fragment.length <= 1) return { kind: "none" };
  const lesson = /^#lesson=([a-z0-9-]+)$/.exec(fragment);
  if (lesson?.[1] !== undefined) return { kind: "lesson", id: lesson[1] };
  const parts = /^#p(\d{1,6})=(.*)$/.exec(fragment);
  if (!parts) return { kind: "foreign" };
  const version = Number(parts[1]);
  if (version !== 1) return { kind: "newer", version };
  const value = unpack(parts[2] ?? "");
  return value === undefined ? { kind: "broken", mistakes: [] } : readShared(value);
}

function unpack(text: string): unknown {
  if (text.length > longest) return undefined;
  // Some programs turn a + of an address into a space.
  const packed = text.replaceAll(" ", "+");
  if (unpackedLength(packed, longestUnpacked) === undefined) return undefined;
  try {
    return JSON.parse(lzString.decompressFromEncodedURIComponent(packed));
  } catch {
    return undefined;
  }
}

function readShared(value: unknown): ReadLink {
  const content = checked(isLinkContent, value);
  if ("mistakes" in content) return { kind: "broken", mistakes: content.mistakes };
  const { own, ...shared } = content.value;
  const missing = missingFiles(shared);
  if (missing.length > 0) return { kind: "broken", mistakes: missing };
  if (!own) return { kind: "shared", shared };
  const parsed = parseLesson(own);
  if ("lesson" in parsed) return { kind: "shared", shared: { ...shared, own: parsed.lesson } };
  const mistakes = parsed.mistakes.map(({ where, message }) => ({
    where: where === "" ? "own" : `own.${where}`,
    message,
  }));
  return { kind: "broken", mistakes };
}
