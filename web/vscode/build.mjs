// Bundles the extension and packs it: everything that it needs is inside.
//   node build.mjs MODULE TARGET     makes TARGET from the compiled packages and oncard-full.wasm
// The same tree gives the same bytes. Tested by test/package.test.ts.

import { copyFileSync, cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import { createVSIX } from "@vscode/vsce";
import { build } from "esbuild";
import { unzipSync, zipSync } from "fflate";

import { noticesOf } from "./notices.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const top = resolve(here, "../..");
const [module, target] = process.argv.slice(2).map((path) => resolve(path));
const stage = join(dirname(target), "vsix");

rmSync(stage, { recursive: true, force: true });
mkdirSync(join(stage, "dist"), { recursive: true });

const common = {
  absWorkingDir: here,
  outdir: join(stage, "dist"),
  bundle: true,
  minify: true,
  legalComments: "none",
  metafile: true,
  logLevel: "warning",
};
const programs = await build({
  ...common,
  entryPoints: {
    extension: "src/extension.ts",
    server: "../language-server/dist/server.js",
    adapter: "../debug-adapter/dist/adapter.js",
    engine: "../engine/dist/module_process.js",
  },
  platform: "node",
  format: "cjs",
  target: "node18",
  external: ["vscode"],
  // ES modules before those for require(): the latter load their parts by computed names.
  mainFields: ["module", "main"],
});
// What panels show are pages in the editor.
const views = await build({
  ...common,
  entryPoints: {
    failing_run: "view/failing_run.tsx",
    machine: "view/machine.tsx",
    two_columns: "view/two_columns.tsx",
  },
  format: "iife",
  target: "es2022",
  jsx: "automatic",
  jsxImportSource: "preact",
});
const metafile = { inputs: { ...programs.metafile.inputs, ...views.metafile.inputs } };

// The extension also explores, and reads records of hosts.
copyFileSync(module, join(stage, "dist/oncard.wasm"));
for (const folder of ["snippets", "syntaxes"]) {
  cpSync(join(here, folder), join(stage, folder), { recursive: true });
}
for (const file of ["language-configuration.json", "package.nls.json", "package.nls.zh-cn.json"]) {
  copyFileSync(join(here, file), join(stage, file));
}
copyFileSync(join(here, "README.md"), join(stage, "README.md"));
copyFileSync(join(top, "LICENSE"), join(stage, "LICENSE.txt"));
writeFileSync(join(stage, "ThirdPartyNotices.txt"), noticesOf(here, metafile));

// What only the workspace needs is left out.
const manifest = JSON.parse(readFileSync(join(here, "package.json"), "utf8"));
for (const name of ["private", "type", "dependencies", "devDependencies"]) delete manifest[name];
writeFileSync(join(stage, "package.json"), `${JSON.stringify(manifest, undefined, 2)}\n`);

// Everything in the folder is meant. vsce looks for its files from the current folder.
writeFileSync(join(stage, ".vscodeignore"), "");
process.chdir(stage);
await createVSIX({
  packagePath: target,
  dependencies: false,
  allowMissingRepository: true,
});

// Without the times of this build.
const files = Object.entries(unzipSync(readFileSync(target))).sort(([a], [b]) => (a < b ? -1 : 1));
const time = new Date(1980, 0, 1);
writeFileSync(target, zipSync(Object.fromEntries(files), { level: 9, mtime: time }));
