// What the reader works on: the open lesson or program of their own, its texts, and what the compiler
// says of them. Every edit is kept at once.

import type { Description, Diagnostic, Project } from "@oncard/engine";
import { type Lesson, parseLesson } from "@oncard/lessons";
import { computed, effect, signal } from "@preact/signals";
import lessons from "virtual:lessons";

import { Bench } from "./session/bench.js";
import { linkWith } from "./share/address.js";
import { type ReadLink, type Shared, writeLink } from "./share/link.js";
import { keep, kept } from "./store/keep.js";
import { isLinkedLessons } from "./store/kept_schema.js";
import { salvaged } from "./store/salvaged.js";
import { language } from "./store/settings.js";
import {
  openFiles,
  readShelf,
  type Shelf,
  withoutOpen,
  withProgram,
  withText,
} from "./store/shelf.js";
import { ownProgram } from "./lesson/own_program.js";

export const bench = new Bench();

/** Lessons of teachers that came in links, kept beside those of the page. */
const linked = signal<Lesson[]>([]);
export const allLessons = computed(() => [ownProgram, ...lessons, ...linked.value]);

export const lesson = signal<Lesson>(ownProgram);
export const shelf = signal<Shelf>({ open: 0, programs: [ownProgram.files] });
export const files = computed(() => openFiles(shelf.value));
/** The file in the editor. */
export const file = signal(ownProgram.program);
export const diagnostics = signal<Diagnostic[]>([]);
/** Why the project could not be checked, for example a mistake in the scenario. */
export const complaint = signal("");
/** The texts have been edited since they were loaded. */
export const edited = signal(false);
/** Grows when the editor must show other texts than those typed into it. */
export const opened = signal(0);

export const project = computed<Project>(() => ({
  main: lesson.value.main,
  files: files.value,
  structured: lesson.value.structured ?? false,
}));

// --- Opening -------------------------------------------------------------------------------------

function shelfOf({ id, files: start }: Lesson): Shelf {
  return readShelf(kept(`shelf.${id}`)) ?? { open: 0, programs: [start] };
}

function show(next: Shelf): void {
  shelf.value = next;
  bench.breakpoints.value = [];
  keep(`shelf.${lesson.value.id}`, next);
  if (!Object.hasOwn(files.value, file.value)) file.value = lesson.value.program;
  opened.value++;
  void checkNow(true);
}

export function openLesson(next: Lesson): void {
  lesson.value = next;
  file.value = next.program;
  keep("lesson", next.id);
  show(shelfOf(next));
}

/** Opens another program of this lesson. */
export function openProgram(index: number): void {
  show({ ...shelf.value, open: index });
}

export function copyProgram(): void {
  const { programs } = shelf.value;
  show({ open: programs.length, programs: [...programs, { ...files.value }] });
}

export function removeProgram(): void {
  show(withoutOpen(shelf.value));
}

/** The lesson's start becomes the open program; what was written stays on the shelf. */
export function resetProgram(): void {
  show(withProgram(shelf.value, lesson.value.files));
}

/** Opens what a link carries. The programs that are there stay. */
export function openShared(shared: Shared): void {
  const { own } = shared;
  if (own) linked.value = [...linked.value.filter(({ id }) => id !== own.id), own];
  const known = own ?? allLessons.value.find(({ id }) => id === shared.lesson) ?? ownProgram;
  const fits =
    Object.hasOwn(shared.files, known.program) && Object.hasOwn(shared.files, known.main);
  lesson.value = fits ? known : { ...ownProgram, program: shared.program, main: shared.main };
  file.value = lesson.value.program;
  keep("lesson", lesson.value.id);
  if (own) keep("linked", linked.value);
  show(withProgram(shelfOf(lesson.value), shared.files));
}

/** The lesson that is opened first: that of the link, else the last one. */
export function openFirst(link: ReadLink): void {
  linked.value = readLinked(salvaged(isLinkedLessons, kept("linked")) ?? []);
  if (link.kind === "shared") {
    openShared(link.shared);
    return;
  }
  const id = link.kind === "lesson" ? link.id : kept("lesson");
  openLesson(allLessons.value.find((each) => each.id === id) ?? lessons[0] ?? ownProgram);
}

export function shareLink(): string {
  const { id, main, program, structured } = lesson.value;
  const shared: Shared = {
    lesson: id,
    files: files.value,
    program,
    main,
    language: language.value,
  };
  if (structured) shared.structured = true;
  if (linked.value.some((each) => each.id === id)) shared.own = lesson.value;
  return addressOf(shared);
}

/** A link with which the lesson begins. */
export function linkOfLesson(own: Lesson): string {
  const { id, files: start, program, main } = own;
  return addressOf({ lesson: id, own, files: start, program, main, language: language.value });
}

function addressOf(shared: Shared): string {
  return linkWith(writeLink(shared), location.href);
}

// --- Editing -------------------------------------------------------------------------------------

let timer: ReturnType<typeof setTimeout> | undefined;

export function edit(name: string, text: string): void {
  if (files.value[name] === text) return;
  shelf.value = withText(shelf.value, name, text);
  keep(`shelf.${lesson.value.id}`, shelf.value);
  edited.value = true;
  clearTimeout(timer);
  timer = setTimeout(() => void checkNow(), 150);
}

/** Checks the texts. What is opened is loaded, and what is edited before the card has begun. */
async function checkNow(isOpening = false): Promise<void> {
  clearTimeout(timer);
  const checked = project.value;
  try {
    const { diagnostics: found } = await bench.check(checked);
    if (checked !== project.value) return;
    diagnostics.value = found;
    complaint.value = "";
    const isLoaded = bench.loaded && bench.project === checked;
    const hasBegun = bench.loaded && (bench.state.value?.moment ?? 0) > 0;
    if (!isLoaded && (isOpening || !hasBegun)) await reload();
  } catch (error) {
    if (checked !== project.value) return;
    diagnostics.value = [];
    complaint.value = error instanceof Error ? error.message : String(error);
  }
}

/** Puts the texts as they are now onto the card. */
export async function reload(): Promise<boolean> {
  edited.value = false;
  return bench.load(project.value);
}

/** What is edited is loaded before anything runs. */
export async function ready(): Promise<boolean> {
  if (edited.value || !bench.loaded) return reload();
  return true;
}

/** Sets a breakpoint at a line of the program, or removes it. */
export function toggleBreakpoint(line: number): void {
  const before = bench.breakpoints.value;
  const next = before.includes(line)
    ? before.filter((each) => each !== line)
    : [...before, line].sort((a, b) => a - b);
  // What was edited has other lines; it is loaded with its breakpoints.
  if (edited.value || !bench.loaded) bench.breakpoints.value = next;
  else void bench.stopAt(next);
}

/** What is at a place of the open file. */
export async function describe(line: number, column: number): Promise<Description | null> {
  const engine = await bench.engine();
  return engine.describe({ ...project.value, file: file.value, line, column });
}

/** Says everything again in the language that is chosen. */
export function followLanguage(): void {
  let spoken = language.peek();
  effect(() => {
    if (language.value === spoken) return;
    spoken = language.value;
    void bench.speak().then(() => checkNow());
  });
}

function readLinked(values: unknown[]): Lesson[] {
  return values.flatMap((value) => {
    const parsed = parseLesson(value);
    return "lesson" in parsed ? [parsed.lesson] : [];
  });
}
