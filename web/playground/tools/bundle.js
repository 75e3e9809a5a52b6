// Builds the page: static files in a folder, which any server of files can hand out.
//   node tools/bundle.js FOLDER MODULE...
// The modules are oncard.wasm and oncard-full.wasm; the first one draws the pictures of the samples. The
// licences of everything that is bundled are put beside them.

import { copyFileSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import { collectLessons } from "@oncard/lessons/collect";
import { collectSamples } from "@oncard/lessons/samples";
import { build } from "esbuild";

import { recordSamples } from "./record_samples.js";

const here = fileURLToPath(new URL("..", import.meta.url));

/** What links to the page show. It is not taken anew, so that the same tree gives the same page. */
const preview = join(here, "../../docs/pictures/playground-preview.png");

/** The lessons and the samples as a module of the bundle. */
const lessonsWith = (pictures) => ({
  name: "lessons",
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /^virtual:lessons$/ }, () => ({ path: "lessons", namespace: "lessons" }));
    onLoad({ filter: /.*/, namespace: "lessons" }, () => ({
      contents: JSON.stringify({
        offered: collectLessons().map(({ lesson }) => lesson),
        samples: collectSamples().map(({ lesson }) => lesson),
        pictures,
      }),
      loader: "json",
    }));
  },
});

/** The folder of the package that a bundled file belongs to; undefined for files of this project. */
function packageOf(path) {
  if (!path.includes("node_modules/")) return undefined;
  let folder = dirname(path);
  while (!existsSync(join(folder, "package.json")) || !nameIn(folder)) folder = dirname(folder);
  return folder;
}

function nameIn(folder) {
  return JSON.parse(readFileSync(join(folder, "package.json"), "utf8")).name;
}

function licenceOf(folder) {
  const { name, version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  const file = ["LICENSE", "LICENSE.md", "LICENSE.txt", "LICENCE", "license"]
    .map((each) => join(folder, each))
    .find(existsSync);
  const text = file ? readFileSync(file, "utf8").trim() : license;
  return `${name} ${version} (${license})\n\n${text}\n`;
}

export async function bundle(folder, modules) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const pictures = await recordSamples(modules[0], collectSamples());
  const { metafile } = await build({
    absWorkingDir: here,
    entryPoints: { main: "src/main.tsx", worker: "src/session/worker.ts" },
    outdir: folder,
    bundle: true,
    minify: true,
    sourcemap: false,
    format: "esm",
    target: ["chrome102", "firefox102", "safari15.4"],
    jsx: "automatic",
    jsxImportSource: "preact",
    alias: {
      entities: "./src/lesson/entities.ts",
      "linkify-it": "./src/lesson/linkify.ts",
      "punycode.js": "./src/lesson/punycode.ts",
    },
    metafile: true,
    legalComments: "none",
    logLevel: "warning",
    plugins: [lessonsWith(pictures)],
  });
  for (const file of ["index.html", "icon.svg"]) copyFileSync(join(here, file), join(folder, file));
  copyFileSync(preview, join(folder, "preview.png"));
  for (const module of modules) copyFileSync(module, join(folder, basename(module)));
  const packages = Object.keys(metafile.inputs).map((path) => packageOf(resolve(here, path)));
  const others = [
    ...new Set(packages.filter((path) => path && !nameIn(path).startsWith("@oncard/"))),
  ];
  const notices = others.sort().map(licenceOf);
  writeFileSync(join(folder, "LICENSES.txt"), notices.join(`\n${"-".repeat(80)}\n\n`));
}

const [folder, ...modules] = process.argv.slice(2);
if (folder && modules.length > 0) await bundle(resolve(folder), modules);
