// Starts the page.

import { effect } from "@preact/signals";
import { render } from "preact";

import { App, link } from "./app.js";
import { listenToKeys } from "./controls/actions.js";
import { readLink } from "./share/link.js";
import { applySettings, language } from "./store/settings.js";
import { texts } from "./texts/texts.js";
import {
  allLessons,
  bench,
  followLanguage,
  openFirst,
  openLesson,
  openShared,
} from "./workspace.js";

import "uplot/dist/uPlot.min.css";
import "./style/base.css";
import "./style/layout.css";
import "./style/parts.css";

function takeLink(isFirst: boolean): void {
  const read = readLink(location.hash);
  if (read.kind === "none" && !isFirst) return;
  if (read.kind === "shared" && read.shared.language) language.value = read.shared.language;
  link.value = read;
  if (isFirst) openFirst(read);
  else if (read.kind === "shared") openShared(read.shared);
  else if (read.kind === "lesson") {
    const lesson = allLessons.value.find(({ id }) => id === read.id);
    if (lesson) openLesson(lesson);
  }
  // The address shall not bring a program again that the reader has changed meanwhile.
  if (read.kind !== "none") history.replaceState(null, "", location.pathname + location.search);
}

applySettings();
effect(() => {
  document.title = texts.value.title;
});
listenToKeys();
takeLink(true);
window.addEventListener("hashchange", () => {
  takeLink(false);
});
followLanguage();
const page = document.getElementById("page");
if (page) render(<App />, page);
void bench.engine().catch(() => undefined); // the status line says why
