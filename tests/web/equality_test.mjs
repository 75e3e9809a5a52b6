// The module gives the answers of this computer's build, byte by byte: results, state hashes,
// diagnostics. Of an exploration only the verdict and the failing schedule are the same: this
// computer runs two searches at the same time, and their counts depend on the clock.
//   node equality_test.mjs MODULE REQUESTS ANSWERS FULL_MODULE
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { EngineModule } from "../../web/engine/engine_module.js";

const [modulePath, requestsPath, answersPath, fullModulePath] = process.argv.slice(2);
const linesOf = (path) => readFileSync(path, "utf8").trimEnd().split("\n");
const engine = await EngineModule.create(readFileSync(modulePath));
const expected = linesOf(answersPath);
const cases = linesOf(requestsPath).map((text, i) => ({
  text,
  request: JSON.parse(text),
  answer: expected[i],
}));

/** The answers to some requests, after it was asserted that they are equal. */
function equalAnswersTo(chosen) {
  return chosen.map(({ text, request, answer }) => {
    const given = engine.handle(text);
    assert.equal(given, answer + "\n", `${request.id}\n${JSON.stringify(request.arguments.files)}`);
    return JSON.parse(given);
  });
}

const runs = cases.filter(({ request }) => request.request === "run");
const walks = cases.filter(({ request }) => request.id.startsWith("walk "));
const isRandom = ({ request }) => request.id === "random.toml";

test("every scenario of the samples has the same result", (t) => {
  const answers = equalAnswersTo(runs.filter((each) => !isRandom(each)));
  const hashes = answers.filter((answer) => answer.result?.run?.state_hash).length;
  t.diagnostic(`${hashes} equal state hashes, ${answers.length - hashes} equal refusals`);
  assert.ok(hashes > 30);
});

test("a thousand random programs have the same results", (t) => {
  const answers = equalAnswersTo(runs.filter(isRandom));
  const hashes = answers.map((answer) => answer.result?.run?.state_hash).filter(Boolean);
  t.diagnostic(`${hashes.length} equal state hashes, ${new Set(hashes).size} different ones`);
  assert.equal(hashes.length, 1000);
  assert.ok(new Set(hashes).size > 900);
});

test("sessions that go forward and back give the same answers", (t) => {
  const answers = equalAnswersTo(walks);
  const good = answers.filter(({ ok }) => ok).length;
  t.diagnostic(`${good} equal answers, ${answers.length - good} equal refusals`);
  assert.ok(good > 1500);
});

test("questions about sources have the same answers", (t) => {
  const answers = equalAnswersTo(
    cases.filter(({ request }) => request.id.startsWith("source ")),
  );
  const good = answers.filter(({ ok }) => ok).length;
  t.diagnostic(`${good} equal answers, ${answers.length - good} equal refusals`);
  assert.ok(good > 3000);
});

test("explorations have the same verdicts", async (t) => {
  const explorer = await EngineModule.create(readFileSync(fullModulePath));
  const explorations = cases.filter(({ request }) => request.request === "explore");
  assert.ok(explorations.length > 5);
  for (const { text, request, answer } of explorations) {
    const given = JSON.parse(explorer.handle(text)).result;
    const wanted = JSON.parse(answer).result;
    assert.equal(given?.report.verdict, wanted?.report.verdict, request.id);
    assert.deepEqual(given?.report.schedule, wanted?.report.schedule, request.id);
  }
  t.diagnostic(`${explorations.length} equal verdicts`);
});
