// The panel with the machine of the program that is debugged.

import { MachineView } from "@oncard/playground/machine";
import { axesShown } from "@oncard/playground/machine/seen";
import { machine as words } from "@oncard/playground/machine/texts";
import { render } from "preact";

import type { FromView, ToView } from "../src/machine_messages";
import { openPanel } from "./panel.js";
import { followTheme } from "./theme.js";

import "@oncard/playground/tokens.css";
import "@oncard/playground/elements.css";
import "@oncard/playground/machine.css";
import "./editor_look.css";
import "./machine.css";

followTheme();
openPanel<ToView, FromView>((main, { machine, language, idle }, _, tell) => {
  if (!language) return;
  render(
    machine ? (
      <MachineView
        {...machine}
        axes={axesShown(machine.card, machine.seen)}
        words={words[language]}
        onInput={(word, pin, level) => {
          tell({ word, pin, level });
        }}
      />
    ) : (
      <p class="muted empty">{idle}</p>
    ),
    main,
  );
});
