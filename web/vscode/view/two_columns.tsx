// The panel with C beside card code: what it shows and what its reader wants are messages.

import { TwoColumnsView } from "@oncard/playground/two_columns";
import { twoColumns } from "@oncard/playground/two_columns/texts";
import { render } from "preact";

import type { FromView, ToView } from "../src/two_columns_messages";
import { openPanel } from "./panel.js";

import "@oncard/playground/elements.css";
import "@oncard/playground/two_columns.css";
import "./editor_look.css";
import "./two_columns.css";

openPanel<ToView, FromView>((main, { shown, language, chosen }, now, tell) => {
  if (!shown || !language) return;
  render(
    <TwoColumnsView
      shown={shown}
      words={twoColumns[language]}
      mark={(file, line) => (file === chosen?.file && line === chosen.line ? "linked" : "")}
      onShow={(file, line) => {
        tell({ file, line });
      }}
    />,
    main,
  );
  if (now.chosen) document.querySelector(".linked")?.scrollIntoView({ block: "nearest" });
});
