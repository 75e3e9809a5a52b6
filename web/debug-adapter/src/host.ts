// A host program: how it is recorded, and how the editor sees it, as one more thread.
// Tested by test/host.test.ts.

import { spawn } from "node:child_process";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";

import type { State, Thread } from "@oncard/engine";

import type { Editor } from "./editor.js";
import type { HostRun, LaunchConfig } from "./launch.js";
import { back, forward, type Movement } from "./movements.js";
import { UserError } from "./texts.js";

/** Its number; the threads of a card have smaller ones. */
export const hostThread = 32;

/** The host as a thread whose function is its next call. */
export function threadOfHost({ host }: State): Thread | undefined {
  if (!host) return undefined;
  return {
    thread: hostThread,
    function: host.next ?? "-",
    page: -1,
    state: host.next === undefined ? "finished" : "running",
    file: "",
    line: 0,
    position: 0,
    statements: 0,
    error: 0,
    status: host.last ?? "",
    ready: false,
  };
}

export const toNextCall: Movement = forward({ goal: "call" }, hostThread);
export const toLastCall: Movement = back({ goal: "call" }, hostThread);

/**
 * Runs the host to its end and hands its record to `use`; the record disappears afterwards.
 * @throws UserError if it cannot be run
 */
export async function withRecord<Result>(
  { oncard, module }: LaunchConfig,
  host: HostRun,
  editor: Editor,
  use: (record: string) => Promise<Result>,
): Promise<Result> {
  if (module !== undefined) {
    throw new UserError({
      en: "a host program needs the 'oncard' command: name it in 'oncard' of the launch configuration",
      zh: "运行主机程序需要“oncard”命令：请在启动配置的“oncard”中指定",
    });
  }
  const folder = await mkdtemp(join(tmpdir(), "oncard-host-"));
  try {
    const record = join(folder, "host.calls");
    const scenario = host.scenario === undefined ? [] : ["--scenario", host.scenario];
    const args = ["exec", "--record", record, ...scenario, "--", ...host.command];
    await run(oncard, args, host.folder, editor);
    return await use(record);
  } finally {
    await rm(folder, { recursive: true });
  }
}

/** What the host prints is shown; its exit code is, too, unless it is 0. */
function run(command: string, args: string[], folder: string, editor: Editor): Promise<void> {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, { cwd: folder, stdio: ["ignore", "pipe", "pipe"] });
    let complaint = "";
    child.stdout.setEncoding("utf8").on("data", (text: string) => {
      editor.print(text, "stdout");
    });
    child.stderr.setEncoding("utf8").on("data", (text: string) => {
      complaint += text;
      editor.print(text, "stderr");
    });
    const fail = (why: string) => {
      reject(new UserError({ en: `the host was not run: ${why}`, zh: `未能运行主机程序：${why}` }));
    };
    child.on("error", (error) => {
      fail(`${command}: ${error.message}`);
    });
    child.on("close", (code, signal) => {
      const how = signal ?? String(code);
      // The command itself has refused.
      if ((code === 2 || code === 3) && complaint.startsWith("oncard:")) fail(complaint.trim());
      else {
        if (code !== 0) {
          const text = { en: `the host has ended with ${how}`, zh: `主机程序以 ${how} 结束` };
          editor.print(`${editor.say(text)}\n`, "console");
        }
        resolve();
      }
    });
  });
}
