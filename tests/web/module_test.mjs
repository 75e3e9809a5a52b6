// What the module imports and exports, and its answers to bad requests.
//   node module_test.mjs MODULE FULL_MODULE
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { gzipSync } from "node:zlib";
import { EngineModule, ModuleError } from "../../web/engine/engine_module.js";

const bytes = readFileSync(process.argv[2]);
const engine = await EngineModule.create(bytes);
const full = await EngineModule.create(readFileSync(process.argv[3]));

/** The request to run a program, after its scenario's other keys. */
const runOf = (source, keys = "") => ({
  id: 1,
  request: "run",
  arguments: { main: "a.toml", files: { "a.toml": `program = "a.c"\n${keys}`, "a.c": source } },
});
const answerTo = (request, asked = engine) =>
  JSON.parse(asked.handle(typeof request === "string" ? request : JSON.stringify(request)));
const counting = runOf("int sum;\nint main() {\n  sum = 41;\n  sum = sum + 1;\n}\n");

test("the module imports nothing: no clock, no random numbers, no files", async () => {
  const module = await WebAssembly.compile(bytes);
  assert.deepEqual(WebAssembly.Module.imports(module), []);
});

test("the module exports few functions", async () => {
  const exports = WebAssembly.Module.exports(await WebAssembly.compile(bytes));
  assert.deepEqual(exports.map(({ name }) => name).sort(), [
    "_initialize",
    "memory",
    "oncard_answer",
    "oncard_handle",
    "oncard_request",
    "oncard_version",
  ]);
});

test("the module has at most 1.2 MB when compressed", (t) => {
  const compressed = gzipSync(bytes, { level: 9 }).length;
  t.diagnostic(`${bytes.length} bytes, compressed ${compressed}`);
  assert.ok(compressed <= 1.2e6);
});

test("the version is that of the project", () => {
  const project = readFileSync(new URL("../../CMakeLists.txt", import.meta.url), "utf8");
  assert.equal(engine.version, project.match(/project\(oncard VERSION (\S+)/)[1]);
});

test("a run answers with values and a hash", () => {
  const { id, ok, result } = answerTo(counting);
  assert.equal(id, 1);
  assert.ok(ok);
  assert.equal(result.run.values.sum, 42);
  assert.match(result.run.state_hash, /^[0-9a-f]{16}$/);
});

test("the same request has the same answer in another instance", async () => {
  const text = JSON.stringify(counting);
  assert.equal((await EngineModule.create(bytes)).handle(text), engine.handle(text));
});

test("what is not JSON, or not an object, is refused", () => {
  for (const text of ["", "{", "42", "null", "[]", '"run"', "[".repeat(1e6), "\0"]) {
    const { ok, error } = answerTo(text);
    assert.equal(ok, false, text.slice(0, 20));
    assert.ok(error.length > 0);
  }
});

test("what is not UTF-8 is refused", () => {
  const text = new TextEncoder().encode(JSON.stringify(counting));
  const place = text.indexOf("s".charCodeAt(0));
  text[place] = 0xff;
  assert.equal(JSON.parse(engine.handle(text)).ok, false);
});

test("members of a wrong type are refused", () => {
  const { arguments: good } = counting;
  for (const wrong of [null, 1, "text", [], true, {}]) {
    for (const request of [
      { ...counting, request: wrong },
      { ...counting, arguments: wrong },
      { ...counting, arguments: { ...good, main: wrong } },
      { ...counting, arguments: { ...good, files: wrong } },
      { ...counting, arguments: { ...good, files: { ...good.files, "a.c": wrong } } },
    ]) {
      if (request.arguments?.files?.["a.c"] === "text") continue; // a program, if a bad one
      const { ok, result } = answerTo(request);
      assert.ok(!ok || !result.compiled, JSON.stringify(request));
    }
  }
});

test("a file that the request does not bring is missing", () => {
  const { arguments: good } = counting;
  const files = { "a.toml": good.files["a.toml"] };
  const { ok, result } = answerTo({ ...counting, arguments: { main: "a.toml", files } });
  assert.ok(!ok || !result.compiled);
  const included = answerTo(runOf('#include "b.h"\nint main() {\n}\n'));
  assert.equal(included.result.compiled, false);
  assert.equal(included.result.diagnostics[0].slug, "cannot-open");
});

test("errors of a program are diagnostics", () => {
  const { ok, result } = answerTo(runOf("int main() {\n  x = 1;\n}\n"));
  assert.ok(ok);
  assert.equal(result.compiled, false);
  assert.equal(result.diagnostics[0].line, 2);
  assert.equal(result.diagnostics[0].slug, "undeclared");
});

test("a program that never ends reaches the limit of its scenario", () => {
  const endless = "int n;\nint main() {\nlbl_again:\n  n = n + 1;\n  goto lbl_again;\n}\n";
  const { result } = answerTo(runOf(endless, "limit_ms = 50\n"));
  assert.equal(result.run.end, "time-limit");
  assert.equal(result.run.time_ms, 50);
});

test("a session stops when its budget is used up, and goes on from there", async () => {
  const session = await EngineModule.create(bytes);
  const ask = (request, parameters) => {
    const text = JSON.stringify({ id: 1, request, arguments: parameters });
    const { ok, result, error } = JSON.parse(session.handle(text).trimEnd().split("\n").at(-1));
    assert.ok(ok, error);
    return result;
  };
  const endless = runOf("int n;\nint main() {\nlbl:\n  n = n + 1;\n  goto lbl;\n}\n");
  assert.ok(ask("load", endless.arguments).compiled);
  const first = ask("forward", { goal: "stop", budget: 1000 });
  assert.equal(first.stop.reason, "budget");
  const second = ask("forward", { goal: "stop", budget: 1000 });
  assert.ok(second.state.statements > first.state.statements);
  const back = ask("go_to", { moment: first.state.moment });
  assert.equal(back.statements, first.state.statements);
});

test("the module for programs says which one explores", () => {
  const { ok, error } = answerTo({ ...counting, request: "explore" });
  assert.ok(!ok);
  assert.match(error, /oncard-full\.wasm/);
});

test("an exploration finds a lost update", () => {
  const source =
    "int sum;\nint add() {\n  int copy;\n  copy = sum;\n  sum = copy + 1;\n}\n";
  const threads = '[[thread]]\nfunction = "add"\n[[thread]]\nthread = 1\npage = 1\nfunction = "add"\n';
  const request = runOf(source, `final = ["sum == 2"]\n${threads}`);
  const { ok, result, error } = answerTo({ ...request, request: "explore" }, full);
  assert.ok(ok, error);
  assert.equal(result.report.verdict, "FAILED");
  assert.match(result.text, /sum is 1, expected 2/);
  const { actual, rows, stale } = result.interleaving;
  assert.equal(actual, "sum is 1, expected 2");
  assert.deepEqual(rows[0].statement, "copy = sum;");
  assert.equal(stale.name, "sum");

  // The schedule is a file that a session follows to the same end.
  const { files } = request.arguments;
  const replay = { main: "a.schedule", files: { ...files, "a.schedule": result.schedule } };
  const { run } = answerTo({ id: 2, request: "run", arguments: replay }).result;
  assert.equal(run.passed, false);
  assert.match(run.failures[0].message, /sum is 1/);
});

test("an exploration says which file is missing, and keeps no schedule of a proof", () => {
  const { arguments: good } = counting;
  const files = { "a.toml": good.files["a.toml"] };
  const request = { id: 1, request: "explore", arguments: { main: "a.toml", files } };
  assert.deepEqual(answerTo(request, full).missing, ["a.c"]);
  const { result } = answerTo({ ...counting, request: "explore" }, full);
  assert.equal(result.report.verdict, "PROVED");
  assert.ok(!("schedule" in result) && !("interleaving" in result));
});

test("nesting that is too deep for the stack is a diagnostic", () => {
  for (const depth of [1000, 100_000]) {
    const deep = `int x;\nint main() {\n  x = ${"(".repeat(depth)}1${")".repeat(depth)};\n}\n`;
    const { result } = answerTo(runOf(deep));
    assert.ok(result.diagnostics.some(({ slug }) => slug === "too-deep"));
  }
});

test("a request that is too large is refused, and the next one is answered", () => {
  assert.throws(() => engine.handle(new Uint8Array(200 * 2 ** 20)), ModuleError);
  assert.equal(answerTo(counting).result.run.values.sum, 42);
});

test("after the module has ended it answers again", async () => {
  // A module that has the same exports and always ends.
  const ending = await EngineModule.create(endingModule());
  assert.throws(() => ending.handle("{}"), ModuleError);
  assert.throws(() => ending.handle("{}"), ModuleError);
});

/** (module (memory 1) (func _initialize) (func that takes or gives an i32, and traps) ...) */
function endingModule() {
  const text = (name) => [name.length, ...new TextEncoder().encode(name)];
  const section = (id, ...content) => [id, content.flat().length, ...content.flat()];
  const names = ["oncard_request", "oncard_handle", "oncard_answer", "oncard_version"];
  const types = [3, [0x60, 0, 0], [0x60, 1, 0x7f, 1, 0x7f], [0x60, 0, 1, 0x7f]];
  const traps = [3, 0, 0x00, 0x0b];
  return new Uint8Array(
    [
      [0, 0x61, 0x73, 0x6d, 1, 0, 0, 0],
      section(1, types.flat()),
      section(3, [5, 0, 1, 2, 2, 2]),
      section(5, [1, 0, 1]),
      section(7, [6, ...text("memory"), 2, 0, ...text("_initialize"), 0, 0],
        names.flatMap((name, i) => [...text(name), 0, i + 1])),
      section(10, [5, 2, 0, 0x0b], traps, traps, traps, traps),
    ].flat(),
  );
}
