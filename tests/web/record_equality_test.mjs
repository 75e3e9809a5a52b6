// The module with everything gives the answers of this computer's build, byte by byte, whichever family
// of cards the host drove; the module for programs refuses the same records.
//   node record_equality_test.mjs MODULE REQUESTS ANSWERS PROGRAM_MODULE
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { EngineModule } from "../../web/engine/engine_module.js";

const [modulePath, requestsPath, answersPath, programModulePath] = process.argv.slice(2);
const linesOf = (path) => readFileSync(path, "utf8").trimEnd().split("\n");
const requests = linesOf(requestsPath);

test("records of hosts of all families give the same answers", async (t) => {
  const engine = await EngineModule.create(readFileSync(modulePath));
  const answers = requests.map((request) => engine.handle(request));
  assert.equal(answers.join(""), readFileSync(answersPath, "utf8"));
  const hashes = answers.map((text) => JSON.parse(text)).filter(({ ok }) => ok);
  t.diagnostic(`${hashes.length} equal answers`);
  assert.equal(hashes.length, requests.length);
});

test("the module for programs reads no records", async () => {
  const engine = await EngineModule.create(readFileSync(programModulePath));
  assert.match(JSON.parse(engine.handle(requests[0])).error, /records of host calls/);
});
