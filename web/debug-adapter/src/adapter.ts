#!/usr/bin/env node
// The debug adapter on its standard input and output.

import { OncardSession } from "./session.js";

new OncardSession(process.env).start(process.stdin, process.stdout);
