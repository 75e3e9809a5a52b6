// The link with which the page was opened, and what it opens.

import { effect } from "@preact/signals";

import { bench } from "../session/bench.js";
import { addLinked, lessonNamed, lessons } from "../store/lessons.js";
import { ownProgram } from "../store/own_program.js";
import { chooseLanguage } from "../store/settings.js";
import { sameFiles } from "../store/shelf.js";
import { slice } from "../store/slice.js";
import { lastLesson, openLesson, openLessonWith, source } from "../store/source.js";
import { lessonLink, type ReadLink, readLink, type Shared } from "./link.js";

const [openedLink, change] = slice<{ link: ReadLink }>({ link: { kind: "none" } });
export { openedLink };

/** What has come with a link and is not on the card yet. */
let opened: Shared | undefined;

export function forgetLink(): void {
  change({ link: { kind: "none" } });
}

/** Opens what the address of the page says; without a link the last lesson, or the opening. */
export function openFirst(): void {
  const link = takeLink();
  if (link.kind === "shared") return;
  const id = link.kind === "lesson" ? link.id : lastLesson();
  const opening = link.kind === "none" ? lessons.opening.peek() : undefined;
  openLesson(lessonNamed(id) ?? opening ?? lessons.offered.peek()[0] ?? ownProgram);
}

/** Opens the link that has come into the address, if there is one. */
export function openNext(): void {
  const link = takeLink();
  const lesson = link.kind === "lesson" ? lessonNamed(link.id) : undefined;
  if (lesson) openLesson(lesson);
}

/** Reads the link of the address, which shall not bring a program again that was changed meanwhile. */
function takeLink(): ReadLink {
  const link = readLink(location.hash);
  if (link.kind === "none") return link;
  change({ link });
  if (link.kind === "shared") openShared(link.shared);
  nameLesson();
  return link;
}

/** What was opened is on the card. True if a link has brought it, and the card goes to a place in its run. */
export function goToShared(): boolean {
  const { files = {}, moment, recording } = opened ?? {};
  opened = undefined;
  if (moment === undefined || !sameFiles(source.files.peek(), files)) return false;
  void goToPlace(moment, recording);
  return true;
}

async function goToPlace(moment: number, recording?: string): Promise<void> {
  if (recording === undefined) return bench.runTo(moment);
  const loaded = await bench.loadRecording(source.project.peek(), recording);
  if (loaded !== undefined) await bench.goTo({ moment });
}

/** Lets the address name the open lesson, if it is one that everybody has, and nothing else. */
function nameLesson(): void {
  const { id } = source.lesson.peek();
  const isOffered = lessons.offered.peek().some((each) => each.id === id);
  const fragment = isOffered ? lessonLink(id) : "";
  history.replaceState(null, "", location.pathname + location.search + fragment);
}

export function followLesson(): void {
  effect(() => {
    source.lesson.value; // eslint-disable-line @typescript-eslint/no-unused-expressions
    nameLesson();
  });
}

function openShared(shared: Shared): void {
  const { own, lesson, files, program, main, language } = shared;
  opened = shared;
  if (language) chooseLanguage(language);
  if (own) addLinked(own);
  const known = own ?? lessonNamed(lesson) ?? ownProgram;
  const fits = Object.hasOwn(files, known.program) && Object.hasOwn(files, known.main);
  openLessonWith(fits ? known : { ...ownProgram, program, main }, files);
}
