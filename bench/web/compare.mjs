// `./x bench web`: how long the WebAssembly module takes for whole runs, relative to this computer's
// build. Both get the same requests of the session protocol, and must give the same answers: the
// kernels of `./x bench vm`, and cards as in `./x bench motion`, driven by a motion program.
// Wall-clock time from request to answer, the median of five.
//   node compare.mjs MODULE ONCARD
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import { EngineModule } from "../../web/engine/engine_module.js";

const [modulePath, oncardPath] = process.argv.slice(2);
const engine = await EngineModule.create(readFileSync(modulePath));
const repetitions = 5;

const kernel = (name, parameters) => ({
  name,
  source: readFileSync(new URL(`../kernels/${name}.c`, import.meta.url), "utf8"),
  scenario:
    `rate = 1000000\n[[thread]]\nfunction = "${name === "sum" ? "add" : name}"\n` +
    `init = { ${parameters} }\n`,
});

const axes = (count, text) => Array.from({ length: count }, (_, i) => text(i + 1)).join("");
const start = (axis, mode) => `  GT_AxisOn(${axis});\n${mode(axis)}  GT_Update(${1 << (axis - 1)});\n`;
const card = (name, count, scenario, mode) => ({
  name,
  source:
    "TTrapPrm trap;\nTJogPrm jog;\nTPid pid;\nint main() {\n  trap.acc = 0.25;\n  trap.dec = 0.125;\n" +
    `  jog.acc = 1;\n  jog.dec = 1;\n${axes(count, (axis) => mode(axis))}}\n`,
  scenario: `axes = 12\nlimit_ms = 1000000\n${scenario}`,
});
const trap = (axis) =>
  start(axis, () => `  GT_PrfTrap(${axis});\n  GT_SetTrapPrm(${axis}, &trap);\n` +
    `  GT_SetPos(${axis}, 1000000);\n  GT_SetVel(${axis}, 5);\n`);
// Example of the servo sample: kp = 20 DAC units for each pulse of error.
const jog = (axis) =>
  `  GT_CtrlMode(${axis}, 0);\n  GT_GetPid(${axis}, 1, &pid);\n  pid.kp = 20;\n` +
  `  GT_SetPid(${axis}, 1, &pid);\n` +
  start(axis, () => `  GT_PrfJog(${axis});\n  GT_SetJogPrm(${axis}, &jog);\n` +
    `  GT_SetVel(${axis}, 10);\n`);
const drives = axes(12, (axis) =>
  `[[world.axis]]\naxis = ${axis}\ndrive = "velocity"\ngain = 100\ntau_ms = 2\n`);

const moving = (axis) => `expect = ["axis${axis}.moving == 1"]\n`;

const cases = [
  kernel("sum", "begin = 1, end = 20000000"),
  kernel("multiply_accumulate", "n = 20000000"),
  kernel("prefix_sum", "n = 20000"),
  kernel("collatz", "n = 100000"),
  card("12 axes, idle, 250 us", 0, "until_ms = 100000\n", () => ""),
  card("8 axes, Trap without servo, 1 ms", 8,
    `cycle_us = 1000\nuntil_ms = 200000\n${moving(8)}`, trap),
  card("12 axes, Jog with servo, 250 us", 12,
    `until_ms = 20000\n${moving(12)}${drives}`, jog),
];

const child = spawn(oncardPath, ["debug", "--stdio"], { stdio: ["pipe", "pipe", "inherit"] });
const lines = createInterface({ input: child.stdout })[Symbol.asyncIterator]();
const native = async (text) => {
  child.stdin.write(`${text}\n`);
  return (await lines.next()).value;
};
const module = async (text) => engine.handle(text).trimEnd();

/** Median of the milliseconds from request to answer, and the answer. */
async function measure(handle, text) {
  const times = [];
  let answer;
  for (let i = 0; i < repetitions; ++i) {
    const begin = performance.now();
    answer = await handle(text);
    times.push(performance.now() - begin);
  }
  return { ms: times.sort((a, b) => a - b)[repetitions >> 1], answer };
}

for (const { name, source, scenario } of cases) {
  const files = { "bench.c": source, "bench.toml": `program = "bench.c"\n${scenario}` };
  const text = JSON.stringify({ id: 1, request: "run", arguments: { main: "bench.toml", files } });
  const here = await measure(native, text);
  const there = await measure(module, text);
  assert.equal(there.answer, here.answer, name);
  assert.ok(JSON.parse(here.answer).result?.run?.passed, here.answer);
  const ratio = (there.ms / here.ms).toFixed(2);
  console.log(
    `${name.padEnd(36)} ${here.ms.toFixed(0).padStart(6)} ms, ` +
      `WebAssembly ${there.ms.toFixed(0).padStart(6)} ms, ratio ${ratio}`,
  );
}
child.stdin.end();
