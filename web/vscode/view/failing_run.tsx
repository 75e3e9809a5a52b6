// The panel with a failing run: what it shows and what its reader wants are messages.

import { FailingRunView } from "@oncard/playground/interleaving";
import { interleaving } from "@oncard/playground/interleaving/texts";
import { render } from "preact";

import type { FromView, ToView } from "../src/failing_run_messages";
import { openPanel } from "./panel.js";
import { followTheme } from "./theme.js";

import "@oncard/playground/tokens.css";
import "@oncard/playground/elements.css";
import "@oncard/playground/interleaving.css";
import "./editor_look.css";
import "./failing_run.css";

followTheme();
openPanel<ToView, FromView>((main, { run, language, now }, _, tell) => {
  if (!run || !language) return;
  render(
    <FailingRunView
      run={run}
      now={now ?? undefined}
      words={interleaving[language]}
      onGoTo={(step) => {
        tell({ step });
      }}
    />,
    main,
  );
});
