// Whether what has been walked through fulfils the scenario.

import { dirname, join } from "node:path";

import type { Engine, Stop } from "@oncard/engine";
import { RefusedError } from "@oncard/engine";

import type { LaunchConfig } from "./launch.js";
import type { Text } from "./texts.js";

export interface Verdict {
  /** As `oncard replay` has it. */
  exitCode: number;
  text: Text;
}

const fulfilled = 0;
const failed = 1;
const unknown = 6;

/** Records the run and lets the engine judge the recording, with the user's choices and changes. */
export async function judge(engine: Engine, config: LaunchConfig): Promise<Verdict> {
  const main = join(dirname(config.program), "verdict.schedule");
  try {
    const { schedule } = await engine.record();
    const { structured } = config;
    const { run } = await engine.run({ main, files: { [main]: schedule }, structured });
    if (run?.passed) return { exitCode: fulfilled, text: { en: "passed", zh: "通过" } };
    const why = (run?.failures ?? [])
      .map(({ expectation, message }) => (expectation ? `${expectation}: ${message}` : message))
      .join("\n");
    return { exitCode: failed, text: { en: `failed\n${why}`, zh: `未通过\n${why}` } };
  } catch (error) {
    if (!(error instanceof RefusedError)) throw error;
    const why = error.message;
    return { exitCode: unknown, text: { en: `no verdict: ${why}`, zh: `无结论：${why}` } };
  }
}

/** A host has judged itself; here it counts whether the card has done the same again. */
export function judgeHost(end: Stop | undefined): Verdict {
  const why = (end?.failed ?? []).join("\n");
  if (why !== "") return { exitCode: failed, text: { en: `failed\n${why}`, zh: `未通过\n${why}` } };
  const text = { en: "the host's calls are over", zh: "主机调用已结束" };
  return { exitCode: fulfilled, text };
}
