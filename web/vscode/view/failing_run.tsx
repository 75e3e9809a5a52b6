// The panel with a failing run: what it shows and what its reader wants are messages.

import { FailingRunView } from "@oncard/playground/interleaving";
import { interleaving } from "@oncard/playground/interleaving/texts";
import { render } from "preact";

import type { FromView, ToView } from "../src/failing_run_messages";
import { followTheme } from "./theme.js";

import "@oncard/playground/tokens.css";
import "@oncard/playground/elements.css";
import "@oncard/playground/interleaving.css";
import "./editor_look.css";
import "./failing_run.css";

declare function acquireVsCodeApi(): { postMessage(message: FromView): void };

const host = acquireVsCodeApi();
const main = document.querySelector("main");
let last: ToView = {};
followTheme();
addEventListener("message", ({ data }: MessageEvent<ToView>) => {
  last = { ...last, ...data };
  const { run, language, now } = last;
  if (!main || !run || !language) return;
  render(
    <FailingRunView
      run={run}
      now={now ?? undefined}
      words={interleaving[language]}
      onGoTo={(step) => {
        host.postMessage({ step });
      }}
    />,
    main,
  );
});
host.postMessage("ready");
