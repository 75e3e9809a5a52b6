// Writes a module beside each JSON Schema of what comes from outside: its types, and validators that
// are compiled, because the page's security policy lets nothing be compiled there.
//
//   node tools/write_schema_modules.js
//
// `npm run build` does this first. Beside a rule that cannot speak for itself, such as a pattern,
// `expected` says in both languages what is expected.

import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

import { Ajv2020 } from "ajv/dist/2020.js";
import standalone from "ajv/dist/standalone/index.js";
import { compile } from "json-schema-to-typescript";

/** The types of which there are validators: the title of a schema, or names of its definitions. */
const schemas = {
  "lessons/src/lesson.schema.json": ["LessonSource"],
  "playground/src/share/link.schema.json": ["LinkContent"],
  "playground/src/store/kept.schema.json": [
    ...["KeptSettings", "SolvedLessons", "OpenHints", "LinkedLessons", "KeptDraft", "KeptShelf"],
    "KeptPlaces",
  ],
};

for (const [path, types] of Object.entries(schemas)) {
  const read = fileURLToPath(new URL(`../${path}`, import.meta.url));
  const written = read.replace(".schema.json", "_schema.ts");
  const text = await moduleOf(JSON.parse(readFileSync(read, "utf8")), types);
  // What has not changed is not compiled again.
  if (existsSync(written) && readFileSync(written, "utf8") === text) continue;
  writeFileSync(written, text);
}

async function moduleOf(schema, types) {
  const interfaces = await compile(schema, schema.title, {
    bannerComment: "",
    additionalProperties: false, // whatever else a table has is not of use
    ignoreMinAndMaxItems: true,
  });
  const banner = [
    "// Written by tools/write_schema_modules.js.",
    "// @ts-nocheck: the validators are JavaScript.",
    'import type { ValidateFunction } from "ajv";',
  ];
  return `${banner.join("\n")}\n\n${interfaces}\n${validatorsOf(schema, types)}`;
}

/** For each type a function `is<Type>`. */
function validatorsOf(schema, types) {
  const ajv = new Ajv2020({
    allErrors: true,
    verbose: true, // mistakes are described with the rule and the value ...
    messages: false, // ... in two languages, by `checked`
    ownProperties: true,
    unicode: false, // the length of a text is that of JavaScript
    inlineRefs: false,
    strictTypes: false, // a rule beside a reference need not repeat its type
    logger: false,
    code: { source: true, esm: true },
  });
  ajv.addVocabulary(["expected", "tsType"]);
  ajv.addSchema(schema);
  const validators = types.map((type) => [
    `is${type}`,
    type === schema.title ? schema.$id : `${schema.$id}#/$defs/${type}`,
  ]);
  return standalone
    .default(ajv, Object.fromEntries(validators))
    .replace(/^"use strict";/, "")
    .replace(/export const is(\w+) = /g, "export const is$1: ValidateFunction<$1> = ");
}
