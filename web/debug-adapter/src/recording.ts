// Keeps what the user has done as a recording.
// Tested by test/recordings.test.ts.

import { writeFile } from "node:fs/promises";
import { basename, dirname, join } from "node:path";

import type { Launched } from "./launched.js";
import { UserError } from "./texts.js";

/** Writes the run up to now beside the program, from where the schedule file names it. */
export async function record({ engine, config }: Launched, file: string): Promise<string> {
  if (basename(file) !== file) {
    throw new UserError({
      en: `'${file}' must be a name without a folder: a recording is kept beside its program`,
      zh: `“${file}”应为不含目录的文件名：记录保存在程序所在目录`,
    });
  }
  const { schedule } = await engine.record();
  const path = join(dirname(config.program), file);
  try {
    await writeFile(path, schedule);
  } catch (error) {
    const why = error instanceof Error ? error.message : "";
    throw new UserError({
      en: `cannot write '${path}': ${why}`,
      zh: `无法写入“${path}”：${why}`,
    });
  }
  return path;
}
