// Starts the page.

import { effect } from "@preact/signals";
import { render } from "preact";
import { offered, samples } from "virtual:lessons";

import { App } from "./app.js";
import { listenToKeys } from "./controls/actions.js";
import { forgetOldVerdicts } from "./lesson/checks.js";
import { beginOpening } from "./lesson/opening.js";
import { followLessons, followWishes } from "./frame/current.js";
import { bench } from "./session/bench.js";
import { followLanguage, followSource } from "./session/messages.js";
import { followLesson, goToShared, openFirst, openNext } from "./share/opened_link.js";
import { listenToOtherTabs } from "./store/keep.js";
import { offerLessons, takeProgress } from "./store/lessons.js";
import { keepPlaces } from "./store/places.js";
import { applySettings, keepSettings } from "./store/settings.js";
import { lastLesson, takeFromElsewhere } from "./store/source.js";
import { texts } from "./texts/texts.js";

import "uplot/dist/uPlot.min.css";
import "./style/tokens.css";
import "./style/elements.css";
import "./style/frame.css";
import "./style/parts.css";
import "./machine/view.css";
import "./interleaving/view.css";
import "./two_columns/view.css";

keepSettings(navigator.language);
applySettings();
keepPlaces();
followWishes();
effect(() => {
  document.title = texts.value.title;
});
listenToKeys();
offerLessons(offered, samples);
const last = lastLesson();
openFirst();
followLesson();
followLessons(last);
listenToOtherTabs(takeProgress);
listenToOtherTabs(takeFromElsewhere);
window.addEventListener("hashchange", openNext);
followSource(() => {
  if (!goToShared()) beginOpening();
});
followLanguage();
forgetOldVerdicts();
const page = document.getElementById("page");
if (page) render(<App />, page);
void bench.engine().catch(() => undefined); // the status line says why
