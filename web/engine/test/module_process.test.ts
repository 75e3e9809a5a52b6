import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { Engine } from "@oncard/engine";
import { ChildProcessTransport } from "@oncard/engine/child-process";
import { textOnDisk } from "@oncard/engine/disk";
import { describe, expect, onTestFinished, test } from "vitest";

import { sample, ScriptedTransport, startEngine, top, wasm, withoutModule } from "./support.js";

function startProcess(): Engine {
  const process = `${top}/web/engine/dist/module_process.js`;
  const engine = new Engine(new ChildProcessTransport("node", [process, wasm]));
  onTestFinished(() => {
    engine.close();
  });
  return engine;
}

function folderOf(files: Record<string, string>): string {
  const folder = mkdtempSync(join(tmpdir(), "oncard-"));
  onTestFinished(() => {
    rmSync(folder, { recursive: true });
  });
  for (const [name, text] of Object.entries(files)) writeFileSync(join(folder, name), text);
  return folder;
}

describe.skipIf(withoutModule)("the module in a process", () => {
  test("answers as the command does", async () => {
    const main = sample("01_sum/two_threads.toml");
    const engine = startProcess();
    engine.supply = textOnDisk;
    expect(await engine.run({ main })).toEqual(await startEngine().run({ main }));
  });

  test("a line may contain what looks like the end of one", async () => {
    const text = "// \u2028 \u2029\nint f()\n{\n}\n";
    const loaded = await startProcess().load({ main: "p.c", files: { "p.c": text } });
    expect(loaded).toMatchObject({ files: [{ text }] });
  });

  test("a counterexample can be walked", async () => {
    const main = sample("26_lost_update/lost.toml");
    const engine = startProcess();
    engine.supply = textOnDisk;
    const { report, text, schedule } = await engine.explore({ main }, "zh");
    expect(report).toMatchObject({ verdict: "FAILED" });
    expect(text).toMatch(/线程/);
    const recording = sample("26_lost_update/lost.schedule");
    const { run } = await engine.run({ main: recording, files: { [recording]: schedule ?? "" } });
    expect(run).toMatchObject({ passed: false });
  });

  test("files of files are supplied", async () => {
    const folder = folderOf({
      "s.toml": 'program = "p.c"',
      "p.c": '#include "a.h"\n#include "b.h"\nint f()\n{\n  n = m;\n}\n',
      "a.h": "int m;\n",
      "b.h": "int n;\n",
    });
    const engine = startProcess();
    const asked: string[] = [];
    engine.supply = (path) => {
      asked.push(path.slice(folder.length + 1));
      return textOnDisk(path);
    };
    const { compiled } = await engine.check({ main: join(folder, "s.toml") });
    expect({ compiled, asked }).toEqual({ compiled: true, asked: ["s.toml", "p.c", "a.h", "b.h"] });
  });
});

test("a file that nobody has is asked for once", async () => {
  const refusal = (id: number, missing: string) =>
    `{"id":${id},"ok":false,"error":"there is no file","missing":["${missing}"]}`;
  const transport = new ScriptedTransport([refusal(1, "a.c"), refusal(2, "b.h")]);
  const engine = new Engine(transport);
  const asked: string[] = [];
  engine.supply = (path) => {
    asked.push(path);
    return Promise.resolve(path === "a.c" ? "text" : undefined);
  };
  await expect(engine.check({ main: "a.c" })).rejects.toThrow("there is no file");
  expect(asked).toEqual(["a.c", "b.h"]);
  expect(transport.sent.map((line) => JSON.parse(line) as unknown)).toMatchObject([
    { arguments: { files: {} } },
    { arguments: { files: { "a.c": "text" } } },
  ]);
});
