// The panel with C beside card code: what it shows and what its reader wants are messages.

import { TwoColumnsView } from "@oncard/playground/two_columns";
import { twoColumns } from "@oncard/playground/two_columns/texts";
import { render } from "preact";

import type { FromView, ToView } from "../src/two_columns_messages";

import "@oncard/playground/elements.css";
import "@oncard/playground/two_columns.css";
import "./editor_look.css";
import "./two_columns.css";

declare function acquireVsCodeApi(): { postMessage(message: FromView): void };

const host = acquireVsCodeApi();
const main = document.querySelector("main");
let last: ToView = {};
addEventListener("message", ({ data }: MessageEvent<ToView>) => {
  last = { ...last, ...data };
  const { shown, language, chosen } = last;
  if (!main || !shown || !language) return;
  render(
    <TwoColumnsView
      shown={shown}
      words={twoColumns[language]}
      mark={(file, line) => (file === chosen?.file && line === chosen.line ? "linked" : "")}
      onShow={(file, line) => {
        host.postMessage({ file, line });
      }}
    />,
    main,
  );
  if (data.chosen) document.querySelector(".linked")?.scrollIntoView({ block: "nearest" });
});
host.postMessage("ready");
