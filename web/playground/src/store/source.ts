// What the reader works on: the open lesson or a program of their own, and its texts. Every edit is
// kept at once.
// Tested by test/source.test.ts.

import type { Project } from "@oncard/engine";
import type { Lesson } from "@oncard/lessons";
import { computed } from "@preact/signals";

import { keep, kept } from "./keep.js";
import { lessons } from "./lessons.js";
import { ownProgram, ownProgramOf } from "./own_program.js";
import {
  type Files,
  openFiles,
  readShelf,
  sameFiles,
  type Shelf,
  withoutOpen,
  withProgram,
  withText,
} from "./shelf.js";
import { slice } from "./slice.js";

interface Source {
  lesson: Lesson;
  shelf: Shelf;
  /** The file in the editor. */
  file: string;
  /** Grows when the editor must show other texts than those typed into it. */
  opened: number;
  /** Another tab has edited this lesson, too. */
  isElsewhere: boolean;
}

const [state, change] = slice<Source>({
  lesson: ownProgram,
  shelf: { open: 0, programs: [ownProgram.files] },
  file: ownProgram.program,
  opened: 0,
  isElsewhere: false,
});

const files = computed(() => openFiles(state.shelf.value));

export const source = {
  ...state,
  /** The texts of the open program. */
  files,
  /** What is compiled and run; another object after each change. */
  project: computed<Project>(() => ({
    main: state.lesson.value.main,
    files: files.value,
    structured: state.lesson.value.structured ?? false,
  })),
};

function shelfOf({ id, files: start }: Lesson): Shelf {
  return readShelf(kept(`shelf.${id}`)) ?? { open: 0, programs: [start] };
}

/** A program of the reader's own brings the names of its files. */
function fitting(lesson: Lesson, shelf: Shelf): Lesson {
  const open = openFiles(shelf);
  const fits = [lesson.program, lesson.main].every((name) => Object.hasOwn(open, name));
  return fits || lesson.id !== ownProgram.id ? lesson : ownProgramOf(open, lessons.samples.peek());
}

function show(opened: Lesson, shelf: Shelf, file: string): void {
  const lesson = fitting(opened, shelf);
  keep(`shelf.${lesson.id}`, shelf);
  const isThere = Object.hasOwn(openFiles(shelf), file);
  change({
    lesson,
    shelf,
    file: isThere ? file : lesson.program,
    opened: source.opened.peek() + 1,
    isElsewhere: source.isElsewhere.peek() && lesson.id === source.lesson.peek().id,
  });
}

function showShelf(shelf: Shelf): void {
  show(source.lesson.peek(), shelf, source.file.peek());
}

/** The lesson that was open when the page was left. */
export function lastLesson(): unknown {
  return kept("lesson");
}

export function openLesson(lesson: Lesson): void {
  keep("lesson", lesson.id);
  show(lesson, shelfOf(lesson), lesson.program);
}

/** Opens a lesson with a program of somebody else's. The programs that are there stay. */
export function openLessonWith(lesson: Lesson, program: Files): void {
  keep("lesson", lesson.id);
  show(lesson, withProgram(shelfOf(lesson), program), lesson.program);
}

/** Opens a sample as a program of the reader's own, beside those that are there. */
export function openSample({ files: start }: Lesson): void {
  keep("lesson", ownProgram.id);
  show(ownProgram, withProgram(shelfOf(ownProgram), start), ownProgram.program);
}

/** Opens another program of this lesson. */
export function openProgram(index: number): void {
  showShelf({ ...source.shelf.peek(), open: index });
}

export function copyProgram(): void {
  const { programs } = source.shelf.peek();
  showShelf({ open: programs.length, programs: [...programs, { ...files.peek() }] });
}

export function removeProgram(): void {
  showShelf(withoutOpen(source.shelf.peek()));
}

/** The lesson's start becomes the open program; what was written stays on the shelf. */
export function resetProgram(): void {
  showShelf(withProgram(source.shelf.peek(), source.lesson.peek().files));
}

export function showFile(file: string): void {
  change({ file });
}

/** The reader has edited a text. */
export function edit(name: string, text: string): void {
  if (files.peek()[name] === text) return;
  const shelf = withText(source.shelf.peek(), name, text);
  change({ shelf });
  keep(`shelf.${source.lesson.peek().id}`, shelf);
}

/** Another tab has kept this. Its programs come onto the shelf beside the one that is open here. */
export function takeFromElsewhere(key: string, value: unknown): void {
  if (key !== `shelf.${source.lesson.peek().id}`) return;
  const theirs = readShelf(value);
  if (!theirs) return;
  const mine = files.peek();
  const { programs: known } = source.shelf.peek();
  // What this tab has read since it was kept is told, too.
  const isNew = theirs.programs.some((each) => !known.some((other) => sameFiles(each, other)));
  const { open, programs } = withProgram(theirs, mine);
  change({
    // The same object: what is on the card has not been edited.
    shelf: { open, programs: programs.map((each, index) => (index === open ? mine : each)) },
    isElsewhere: isNew || source.isElsewhere.peek(),
  });
}
