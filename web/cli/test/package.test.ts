// The package as npm has it: packed, unpacked, with nothing else, beside the installed command. What
// both print, write and return must be the same, byte for byte.

import { type ChildProcessWithoutNullStreams, spawn, spawnSync } from "node:child_process";
import {
  chmodSync,
  cpSync,
  existsSync,
  lstatSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  symlinkSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { afterAll, beforeAll, describe, expect, onTestFinished, test } from "vitest";

import { oncard, sample, top } from "../../engine/test/support.js";

const command = `${top}/build/web/oncard-cli.wasm`;
const full = `${top}/build/web/oncard-full.wasm`;

/** Of the packed file, in bytes: it is downloaded. */
const sizeMax = 3_500_000;

const few = ["01_sum", "02_loops", "10_trap", "26_lost_update", "33_bus_start"];

interface Ended {
  status: number | null;
  out: string;
  err: string;
}

/** What a command leaves in its folder. */
type Content = Record<string, string>;

describe.skipIf(!existsSync(command))("the package", () => {
  let work = "";
  let installed = "";
  let packed = "";

  beforeAll(() => {
    work = mkdtempSync(join(tmpdir(), "oncard-"));
    const made = spawnSync(
      process.execPath,
      [join(top, "web/cli/build.mjs"), command, full, work],
      { encoding: "utf8" },
    );
    if (made.status !== 0) throw new Error(made.stderr);
    packed = join(work, made.stdout.trim());
    installed = join(work, "installed");
    mkdirSync(installed);
    const unpacked = spawnSync("tar", ["-xzf", packed, "-C", installed], { encoding: "utf8" });
    if (unpacked.status !== 0) throw new Error(unpacked.stderr);
  }, 60_000);
  afterAll(() => {
    rmSync(work, { recursive: true, force: true });
  }, 60_000);

  const script = () => join(installed, "package/oncard.mjs");

  /** A new folder with copies of samples. */
  function folder(...samples: string[]): string {
    const path = mkdtempSync(join(work, "folder-"));
    for (const each of samples) cpSync(sample(each), join(path, each), { recursive: true });
    return path;
  }

  function end(file: string, args: string[], cwd: string, environment = {}): Ended {
    const { status, stdout, stderr } = spawnSync(file, args, {
      cwd,
      encoding: "latin1",
      env: { ...process.env, LANG: "C", LC_ALL: "", ONCARD_LANG: "", ...environment },
      maxBuffer: 1 << 28,
    });
    return { status, out: stdout, err: stderr };
  }

  const native = (args: string[], cwd: string, environment = {}) =>
    end(oncard, args, cwd, environment);
  const npm = (args: string[], cwd: string, environment = {}) =>
    end(process.execPath, [script(), ...args], cwd, environment);

  test("has what it needs and nothing else", () => {
    expect(readdirSync(join(installed, "package")).sort()).toEqual([
      "LICENSE",
      "README.md",
      "ThirdPartyNotices.txt",
      "oncard-cli.wasm",
      "oncard.mjs",
      "oncard.wasm",
      "package.json",
    ]);
    expect(statSync(packed).size).toBeLessThan(sizeMax);
  });

  test.each([
    ["--version"],
    ["run", "--help"],
    ["test", "--help", "--lang=zh"],
    ["check", "01_sum/sum.c", "--format=json"],
    ["build", "01_sum/sum.c", "02_loops/loops.c"],
    ["build", "01_sum/sum.c", "-o", "01_sum/sum.c"],
    ["lower", "02_loops/structured.c", "--cost"],
    ["run", "01_sum/two_threads.toml", "--format=json"],
    ["run", "10_trap/trap.toml", "--steps", "--trace", "t.vcd", "--record", "other/../t.schedule"],
    ["run", "10_trap/trap.toml", "--record", "10_trap/t.schedule", "--lang=zh"],
    ["run", "01_sum/sum.c", "--trace", "01_sum"],
    ["run", "01_sum/sum.c", "--trace", "none/t.csv"],
    ["run", "01_sum/sum.c", "--rate", "0"],
    ["run", "01_sum/none.c"],
    ["run", "01_sum"],
    ["explore", "26_lost_update/lost.toml", "--engine=dpor"],
    [
      "explore",
      "26_lost_update/lost.toml",
      "--engine=stateful",
      "--format=json",
      "--save",
      "s.schedule",
    ],
    ["explain", "MP027"],
    ["explain", "--lang=zh"],
    ["schema"],
    ["eni", "33_bus_start/bus_start.host.toml", "-o", "Gecat.eni"],
    ["doctor", "--commands", "--family=gt400", "--lang=zh"],
    ["doctor", "--commands", "--format=json"],
    ["test", "01_sum", "--format=junit"],
    ["test", "01_sum/two_threads.toml", "--program", "0[1-2]*/*.c", "--format=csv"],
    ["test", "01_sum/two_threads.toml", "--program", "none/*.c"],
    ["test", "none"],
    ["new", "drill", "--host=cpp"],
    ["new", "a-b"],
    ["chek", "01_sum/sum.c"],
    ["run", "--shwo", "x"],
    [],
  ])("does what the installed command does: %s %s %s", (...args: string[]) => {
    const [one, other] = [folder(...few), folder(...few)];
    expect(npm(args, other)).toEqual(native(args, one));
    expect(contentOf(other)).toEqual(contentOf(one));
  });

  test("repeats what the installed command has recorded", () => {
    const at = folder(...few);
    native(["run", "26_lost_update/lost.toml", "--record", "r.schedule"], at);
    native(["build", "01_sum/sum.c"], at);
    for (const args of [
      ["replay", "r.schedule", "--format=json"],
      ["dump", "01_sum/sum.bin"],
      ["verify", "01_sum/sum.bin"],
    ]) {
      expect(npm(args, at)).toEqual(native(args, at));
    }
  });

  test("makes a project, and overwrites nothing", () => {
    const [one, other] = [folder(), folder()];
    const args = ["new", "drill", "--host=cs", "--lang=zh"];
    for (const status of [0, 3]) {
      const made = npm(args, other);
      expect(made).toEqual(native(args, one));
      expect(made.status).toBe(status);
      expect(contentOf(other)).toEqual(contentOf(one));
    }
  });

  test("tests the samples like the installed command, but for hosts", () => {
    const at = folder(".");
    const scenarios = (readdirSync(at, { recursive: true }) as string[])
      .filter((each) => each.endsWith(".toml") && !each.endsWith(".host.toml"))
      .sort();
    const args = ["test", "--format=json", ...scenarios];
    expect(scenarios.length).toBeGreaterThan(30);
    expect(npm(args, at)).toEqual(native(args, at));
    const host = npm(["test", "18_lines"], at);
    expect(host.status).toBe(0);
    expect(host.out).toContain("skip 18_lines/lines.host.toml\n     skipped: host programs need");
  }, 60_000); // all samples, each by both commands

  test("says what it is made of, and what it cannot draw", () => {
    const { status, out, err } = npm(["doctor", "--format=json"], folder());
    expect([status, err]).toEqual([0, ""]);
    expect(JSON.parse(out)).toMatchObject({
      compiler: expect.stringContaining("Clang") as unknown,
      optional: { gbk: { present: true }, gnuplot: { present: false } },
    });
  });

  test("says in the language of the environment what it cannot do", () => {
    const at = folder(...few);
    for (const name of ["exec", "serve"]) {
      const { status, out, err } = npm([name, "--card", "x", "--", "./host"], at);
      expect([status, out]).toEqual([2, ""]);
      expect(err).toContain(`oncard: '${name}' needs an installed oncard`);
    }
    const chinese = npm(["exec", "--", "./host"], at, { LANG: "zh_CN.UTF-8" });
    expect(Buffer.from(chinese.err, "latin1").toString()).toContain("“exec”需要安装的 oncard");
  });

  test("ends a test at its time limit, and runs the others", () => {
    const at = folder(...few);
    const endless = "int i;\nint main() {\nagain:\n  i = 1;\n  goto again;\n}\n";
    writeFileSync(join(at, "endless.c"), endless);
    writeFileSync(join(at, "long.toml"), 'program = "endless.c"\nlimit_ms = 1000000000\n');
    const tests = ["long.toml", "01_sum/one_thread.toml", "long.toml", "01_sum/two_threads.toml"];
    const { status, out } = npm(["test", ...tests, "--timeout", "1", "--jobs", "1"], at);
    expect(status).toBe(1);
    expect(out.match(/FAIL long.toml\n {5}it took longer than 1 s/g)).toHaveLength(2);
    expect(out).toContain("ok   01_sum/one_thread.toml\n");
    expect(out).toContain("ok   01_sum/two_threads.toml\n");
  });

  test("ends a search at its time limit", () => {
    const at = folder(...few);
    const body = Array.from({ length: 40 }, () => "  sum = sum + 1;\n").join("");
    const threads = [0, 1, 2].map((i) => `void t${i}() {\n${body}}\n`).join("");
    writeFileSync(join(at, "wide.c"), `int sum;\n${threads}`);
    const starts = [0, 1, 2].map((i) => `[[thread]]\nthread = ${i}\nfunction = "t${i}"\n`);
    const toml = `program = "wide.c"\n${starts.join("")}`;
    writeFileSync(join(at, "wide.toml"), toml);
    const { status, out } = npm(["explore", "wide.toml", "--engine=dpor", "--time", "1"], at);
    expect(status, out).toBe(6);
  });

  test.skipIf(process.platform === "win32")("keeps the mode of a file, and follows a link", () => {
    const at = folder(...few);
    writeFileSync(join(at, "t.csv"), "old");
    chmodSync(join(at, "t.csv"), 0o640);
    symlinkSync("t.csv", join(at, "link.csv"));
    const { status } = npm(["run", "10_trap/trap.toml", "--trace", "link.csv"], at);
    expect(status).toBe(0);
    expect(lstatSync(join(at, "link.csv")).isSymbolicLink()).toBe(true);
    expect(statSync(join(at, "t.csv")).mode & 0o777).toBe(0o640);
    expect(readFileSync(join(at, "t.csv"), "utf8")).toMatch(/^time_ms,/);
    expect(readdirSync(at).filter((each) => each.startsWith(".oncard-"))).toEqual([]);
  });

  test("answers a debugger line by line", async () => {
    const child = start(["debug", "--stdio"]);
    child.stdin.write('{"id":1,"request":"describe"}\n');
    expect(JSON.parse(await firstLine(child))).toMatchObject({ id: 1 });
  });

  test.each([
    ["lsp", { jsonrpc: "2.0", id: 1, method: "initialize", params: { capabilities: {} } }],
    ["dap", { seq: 1, type: "request", command: "initialize", arguments: { adapterID: "oncard" } }],
  ])("is a server for editors: %s", async (name, request) => {
    const child = start([name]);
    const text = JSON.stringify(request);
    child.stdin.write(`Content-Length: ${text.length}\r\n\r\n${text}`);
    expect(await firstLine(child)).toMatch(/^Content-Length: \d+/);
  });

  function start(args: string[]): ChildProcessWithoutNullStreams {
    const child = spawn(process.execPath, [script(), ...args], { cwd: work });
    onTestFinished(() => {
      child.kill();
    });
    return child;
  }
});

/** All files of a folder, each character a byte. */
function contentOf(folder: string): Content {
  const files = (readdirSync(folder, { recursive: true }) as string[]).filter((each) =>
    statSync(join(folder, each)).isFile(),
  );
  return Object.fromEntries(
    files.sort().map((each) => [each, readFileSync(join(folder, each), "latin1")]),
  );
}

function firstLine(child: ChildProcessWithoutNullStreams): Promise<string> {
  return new Promise((resolve, reject) => {
    let text = "";
    child.stdout.on("data", (data: Buffer) => {
      text += data.toString();
      if (text.includes("\n")) resolve(text.slice(0, text.indexOf("\n")).trim());
    });
    child.on("exit", (code) => {
      reject(new Error(`it has ended with ${String(code)}`));
    });
  });
}
