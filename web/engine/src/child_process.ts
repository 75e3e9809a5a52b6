// An engine in a process of its own: `oncard debug --stdio`, or the module in module_process.ts.
// Tested by test/child_process.test.ts.

import { type ChildProcessWithoutNullStreams, spawn } from "node:child_process";
import { StringDecoder } from "node:string_decoder";

import type { Receiver, Transport } from "./transport.js";

const complaintMax = 4000;

export class ChildProcessTransport implements Transport {
  readonly #executable: string;
  readonly #child: ChildProcessWithoutNullStreams;
  /** The last of what it has written to its standard error. */
  #complaint = "";
  #closed = false;

  /**
   * @param executable path of `oncard`, or a name that is looked for in PATH; or another program
   * @param args with which it speaks the protocol on its standard streams
   * @param environment of the process; that of this one without it
   */
  constructor(
    executable: string,
    args: readonly string[] = ["debug", "--stdio"],
    environment: NodeJS.ProcessEnv = process.env,
  ) {
    this.#executable = executable;
    this.#child = spawn(executable, args, { windowsHide: true, env: environment });
  }

  connect(receiver: Receiver): void {
    const end = (why: string) => {
      if (this.#closed) return;
      this.#closed = true;
      receiver.ended(new Error(why));
    };
    this.#child.on("error", (error: NodeJS.ErrnoException) => {
      const missing = error.code === "ENOENT";
      end(
        `cannot start '${this.#executable}': ${missing ? "there is no such program" : error.message}`,
      );
    });
    const decoder = new StringDecoder("utf8");
    this.#child.stderr.on("data", (data: Buffer) => {
      this.#complaint = (this.#complaint + decoder.write(data)).slice(-complaintMax);
    });
    // Writing to a process that has ended fails; its end is reported below.
    this.#child.stdin.on("error", () => undefined);
    this.#child.on("close", (code, signal) => {
      const how = signal === null ? `with exit code ${code ?? 0}` : `by signal ${signal}`;
      const complaint = this.#complaint.trim();
      end(`'${this.#executable}' has ended ${how}${complaint === "" ? "" : `: ${complaint}`}`);
    });
    const output = new StringDecoder("utf8");
    let begun = "";
    this.#child.stdout.on("data", (data: Buffer) => {
      const lines = (begun + output.write(data)).split("\n");
      begun = lines.pop() ?? "";
      for (const line of lines) if (!this.#closed) receiver.line(line);
    });
  }

  send(line: string): void {
    this.#child.stdin.write(`${line}\n`);
  }

  close(): void {
    this.#closed = true;
    this.#child.kill();
  }
}
