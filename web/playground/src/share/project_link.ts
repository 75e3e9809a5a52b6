// Links of what the reader works on.

import type { Lesson } from "@oncard/lessons";

import { lessons } from "../store/lessons.js";
import { settings } from "../store/settings.js";
import { source } from "../store/source.js";
import { linkWith } from "./address.js";
import { type Shared, writeLink } from "./link.js";

/** The link of the open program. */
export function shareLink(): string {
  const lesson = source.lesson.peek();
  const { id, main, program, structured } = lesson;
  const shared: Shared = { lesson: id, files: source.files.peek(), program, main };
  if (structured) shared.structured = true;
  if (lessons.linked.peek().some((each) => each.id === id)) shared.own = lesson;
  return addressOf(shared);
}

/** A link with which a lesson begins. */
export function linkOfLesson(own: Lesson): string {
  const { id, files, program, main } = own;
  return addressOf({ lesson: id, own, files, program, main });
}

function addressOf(shared: Shared): string {
  const language = settings.language.peek();
  return linkWith(writeLink({ ...shared, language }), location.href);
}
