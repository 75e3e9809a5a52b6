// Links that carry a whole project in the fragment of their address: `#p1=` and compressed JSON.
// The digit is the version. Nothing in a link is trusted.
// Tested by test/link.test.ts.

import { type Lesson, limits, type Mistake, parseLesson } from "@oncard/lessons";
import type { Language } from "@oncard/engine";
import lzString from "lz-string";

import { type Files, isFiles } from "../store/shelf.js";
import { unpackedLength } from "./unpacked_length.js";

export interface Shared {
  /** The lesson that it belongs to; none: a program of its own. */
  lesson?: string;
  /** A lesson of a teacher's own, with all its texts. */
  own?: Lesson;
  files: Files;
  program: string;
  main: string;
  structured?: boolean;
  language?: Language;
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
  return typeof value === "object" && value !== null && !Array.isArray(value)
    ? readShared(value as Record<string, unknown>)
    : { kind: "broken", mistakes: [] };
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

function readShared(value: Record<string, unknown>): ReadLink {
  const broken: ReadLink = { kind: "broken", mistakes: [] };
  const { files, program, main, lesson, structured, language, own } = value;
  if (!isFiles(files) || Object.values(files).some((text) => text.length > limits.file)) {
    return broken;
  }
  const isName = (name: unknown): name is string =>
    typeof name === "string" && Object.hasOwn(files, name);
  if (!isName(program) || !isName(main)) return broken;
  const shared: Shared = { files, program, main };
  if (own !== undefined) {
    const parsed = parseLesson(own);
    if ("mistakes" in parsed) return { kind: "broken", mistakes: parsed.mistakes };
    shared.own = parsed.lesson;
  }
  if (typeof lesson === "string" && /^[a-z0-9-]{1,64}$/.test(lesson)) shared.lesson = lesson;
  if (structured === true) shared.structured = true;
  if (language === "en" || language === "zh") shared.language = language;
  return { kind: "shared", shared };
}
