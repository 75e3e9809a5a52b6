// A whole session as it goes over the wire: requests, responses and events in their order.
// transcript.txt is the expected text.

import { spawn } from "node:child_process";

import type { DebugProtocol } from "@vscode/debugprotocol";
import { expect, onTestFinished, test } from "vitest";

import { adapter, oncard, sample } from "./support.js";

const folder = sample("01_sum");

/** Messages with their headers, and the lines of the transcript. */
class Wire {
  readonly lines: string[] = [];
  readonly #child = spawn("node", [adapter], { env: { ...process.env, ONCARD: oncard } });
  #received = Buffer.alloc(0);
  #requests = 0;
  #wanted = "";
  #found: () => void = () => undefined;

  constructor() {
    onTestFinished(() => {
      this.#child.kill();
    });
    this.#child.stdout.on("data", (data: Buffer) => {
      this.#received = Buffer.concat([this.#received, data]);
      while (this.#take());
    });
  }

  /** Sends a request and waits for the last message that it causes. */
  async send(command: string, args: unknown, last = `response ${command}`): Promise<void> {
    const found = new Promise<void>((resolve) => {
      this.#found = resolve;
    });
    this.#wanted = last;
    const request = { seq: ++this.#requests, type: "request", command, arguments: args };
    const body = JSON.stringify(request);
    this.#write(`request ${command}`, args);
    this.#child.stdin.write(`Content-Length: ${Buffer.byteLength(body)}\r\n\r\n${body}`);
    await found;
  }

  /** Takes a message off what was received; false if it is not complete. */
  #take(): boolean {
    const header = /^Content-Length: (\d+)\r\n\r\n/.exec(this.#received.toString("latin1"));
    if (!header) return false;
    const end = header[0].length + Number(header[1]);
    if (this.#received.length < end) return false;
    const text = this.#received.subarray(header[0].length, end).toString();
    this.#received = this.#received.subarray(end);
    this.#show(JSON.parse(text) as DebugProtocol.Response | DebugProtocol.Event);
    return true;
  }

  #show(message: DebugProtocol.Response | DebugProtocol.Event): void {
    let title: string;
    if ("event" in message) {
      title = `event ${message.event}`;
      this.#write(title, message.body);
    } else {
      title = `${message.success ? "response" : "error"} ${message.command}`;
      this.#write(title, message.success ? message.body : message.message);
    }
    if (title === this.#wanted) this.#found();
  }

  #write(title: string, body: unknown): void {
    const text = body === undefined ? title : `${title} ${JSON.stringify(body)}`;
    this.lines.push(text.replaceAll(folder, "FOLDER"));
  }
}

test("a session", async () => {
  const wire = new Wire();
  const thread = { threadId: 1 };
  const source = { path: sample("01_sum/sum.c") };
  const program = sample("01_sum/two_threads.toml");
  await wire.send("initialize", { adapterID: "oncard" });
  await wire.send("launch", { program, stopOnEntry: true }, "event initialized");
  await wire.send("setBreakpoints", { source, breakpoints: [{ line: 17 }] });
  await wire.send("configurationDone", undefined, "event stopped");
  await wire.send("threads", undefined);
  await wire.send("continue", thread, "event stopped");
  await wire.send("stackTrace", thread);
  await wire.send("scopes", { frameId: 1 });
  await wire.send("variables", { variablesReference: 1001 });
  await wire.send("evaluate", { expression: "i", frameId: 1, context: "hover" });
  await wire.send("evaluate", { expression: "thread 1", context: "repl" }, "event stopped");
  await wire.send("stepBack", { threadId: 2 }, "event stopped");
  await wire.send("setBreakpoints", { source, breakpoints: [] });
  await wire.send("continue", thread, "event stopped");
  await wire.send("next", thread, "error next");
  await wire.send("continue", thread, "event terminated");
  await wire.send("disconnect", undefined);
  await expect(`${wire.lines.join("\n")}\n`).toMatchFileSnapshot("transcript.txt");
});
