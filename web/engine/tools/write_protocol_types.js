// Writes the types of the session protocol from its schema:
//
//   oncard schema --protocol | node write_protocol_types.js ../src/protocol.ts
//
// Tested by ../test/protocol.test.ts.

import { writeFileSync } from "node:fs";
import { json } from "node:stream/consumers";

import { compile } from "json-schema-to-typescript";

const schema = await json(process.stdin);
const types = await compile(schema, schema.title, {
  bannerComment: "// Written by `npm run protocol` from the schema of the session protocol.",
  style: { printWidth: 100 },
});
writeFileSync(process.argv[2], types);
