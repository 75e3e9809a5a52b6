// The panel with C beside card code: what it shows and what its reader wants are messages.

import { TwoColumnsView } from "@oncard/playground/two_columns";
import { twoColumns } from "@oncard/playground/two_columns/texts";
import { render } from "preact";

import type { FromView, Place, ToView } from "../src/two_columns_messages";
import { openPanel } from "./panel.js";

import "@oncard/playground/elements.css";
import "@oncard/playground/two_columns.css";
import "./editor_look.css";
import "./two_columns.css";

openPanel<ToView, FromView>((main, { shown, language, chosen }, now, tell) => {
  if (!shown || !language) return;
  const draw = (pointed?: Place) => {
    const isAt = (place: Place | undefined, file: string, line: number) =>
      file === place?.file && line === place.line;
    render(
      <TwoColumnsView
        shown={shown}
        words={twoColumns[language]}
        mark={(file, line) =>
          isAt(chosen, file, line) ? "linked" : isAt(pointed, file, line) ? "pointed" : ""
        }
        onPoint={(place) => {
          draw(place);
          tell({ point: place ?? null });
        }}
        onShow={(file, line) => {
          tell({ show: { file, line } });
        }}
      />,
      main,
    );
  };
  draw();
  if (now.chosen) document.querySelector(".linked")?.scrollIntoView({ block: "nearest" });
});
