import { readFileSync } from "node:fs";

import { Engine, ModuleTransport } from "@oncard/engine";
import { EngineModule } from "@oncard/engine/engine_module.js";
import { expect, test } from "vitest";

import { startEngine, wasm, withoutModule } from "./support.js";

test.skipIf(withoutModule)("a session in the module is one in a process", async () => {
  const walk = async (engine: Engine) => {
    const program = "int x;\nint f()\n{\n  x = 1;\n  x = 2;\n  return x;\n}\n";
    const log: unknown[] = [];
    engine.onLog = (event) => log.push(event);
    await engine.load({ main: "p.c", files: { "p.c": program } });
    await engine.setStops({ lines: [{ line: 5, log: "x = {x}" }] });
    const end = await engine.walkForward({ goal: "stop" });
    const back = await engine.walkBack({ goal: "change", name: "x" });
    return { log, end, back, variables: await engine.variables() };
  };
  const inModule = await walk(
    new Engine(new ModuleTransport(await EngineModule.create(readFileSync(wasm)))),
  );
  expect(inModule).toEqual(await walk(startEngine()));
  expect(inModule.variables).toMatchObject([{ name: "x", value: 1 }]);
});

test("lines before the last one are events", async () => {
  const event = '{"event":"log","moment":1,"thread":0,"text":"a"}';
  const answer = '{"id":1,"ok":true,"result":{"moment":2}}';
  const engine = new Engine(new ModuleTransport({ handle: () => `${event}\n${answer}\n` }));
  const log: string[] = [];
  engine.onLog = ({ text }) => log.push(text);
  expect(await engine.state()).toEqual({ moment: 2 });
  expect(log).toEqual(["a"]);
});

test("a module that loses its session ends it", async () => {
  const handle = () => {
    throw new Error("the memory is full");
  };
  const engine = new Engine(new ModuleTransport({ handle }));
  const ended: string[] = [];
  engine.onEnded = ({ message }) => ended.push(message);
  await expect(engine.state()).rejects.toThrow("the memory is full");
  await expect(engine.state()).rejects.toThrow("the memory is full");
  expect(ended).toEqual(["the memory is full"]);
});

test("a session that is closed asks nothing more", async () => {
  const asked: string[] = [];
  const handle = (request: string) => {
    asked.push(request);
    return "";
  };
  const engine = new Engine(new ModuleTransport({ handle }));
  const state = engine.state();
  engine.close();
  await expect(state).rejects.toThrow("the session was closed");
  expect(asked).toEqual([]);
});
