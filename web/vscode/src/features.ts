// Everything that the extension adds to the editor itself; the rest is the language server.
// Tested by test/contributions.test.ts.

import { type Disposable, window } from "vscode";

import { registerCommands } from "./commands";
import { registerDebug } from "./debug";
import type { Engines } from "./engines";
import { FailingRunPanel } from "./failing_run";
import { registerInlineValues } from "./inline_values";
import { registerLenses } from "./lenses";
import { registerListing } from "./listing";
import { MachinePanel } from "./machine";
import { registerTests } from "./scenario_tests";
import { followSessions } from "./sessions";
import { registerTasks } from "./tasks";
import { registerTwoColumns } from "./two_columns";

export function registerFeatures(engines: Engines): Disposable[] {
  const output = window.createOutputChannel("oncard");
  const failingRun = new FailingRunPanel(engines);
  const machine = new MachinePanel(engines);
  return [
    output,
    ...registerDebug(engines),
    failingRun,
    ...machine.register(),
    followSessions([failingRun, machine]),
    ...registerCommands(engines, output, failingRun),
    ...registerListing(engines),
    ...registerTwoColumns(engines),
    ...registerTests(engines),
    registerTasks(engines),
    ...registerLenses(engines),
    registerInlineValues(),
  ];
}
