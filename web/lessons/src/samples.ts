// The samples of the page: scenarios of samples/ with a program that shows something. samples.toml lists
// them in their order; the page opens with the first one. For bundlers and tests.
// Tested by test/samples.test.ts.

import { readFileSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

import { parse } from "smol-toml";

import { readLesson } from "./collect.js";
import type { Lesson } from "./lesson.js";

const list = fileURLToPath(new URL("../samples.toml", import.meta.url));
const samples = fileURLToPath(new URL("../../../samples/", import.meta.url));

/** What a small picture of a sample shows: the way of two axes, stages, or who ran when. */
export type PictureKind = "path" | "axes" | "threads";

export interface Sample {
  /** Without hints. */
  lesson: Lesson;
  picture: PictureKind;
}

interface Entry {
  picture: PictureKind;
  /** In samples/. */
  scenario: string;
}

/**
 * The samples in their order.
 * @throws {Error} a file is missing, or a sample has a mistake
 */
export function collectSamples(): Sample[] {
  const { sample } = parse(readFileSync(list, "utf8"));
  return (sample as unknown as Entry[]).map(({ scenario, picture, ...words }) => {
    const path = join(samples, scenario);
    const main = basename(path);
    const text = readFileSync(path, "utf8");
    const { program } = parse(text) as { program: string };
    const files = {
      [program]: readFileSync(join(dirname(path), program), "utf8"),
      [main]: text,
    };
    const usual = { version: 1, hints: [], task: "run" };
    return { lesson: readLesson({ ...usual, ...words, files, program, main }, scenario), picture };
  });
}
