// Links of what the reader works on.

import type { Lesson } from "@oncard/lessons";

import { failingRun, isOnCard } from "../interleaving/failing_run.js";
import { present, session } from "../session/bench.js";
import { isEdited } from "../session/on_card.js";
import { record } from "../session/record.js";
import { lessons } from "../store/lessons.js";
import { settings } from "../store/settings.js";
import { source } from "../store/source.js";
import { linkWith } from "./address.js";
import { type Shared, writeLink } from "./link.js";

/** Where a run is. */
export interface Place {
  moment: number;
  /** A schedule that repeats the run. */
  recording?: string;
}

/** The place of the card in its run; undefined at the start, and where no link could lead. */
export function presentPlace(): Place | undefined {
  const { moment = 0 } = present.state.peek() ?? {};
  if (moment === 0 || isEdited.peek() || record.peek()) return undefined;
  const { value: failing } = failingRun;
  if (failing && isOnCard.peek()) return { moment, recording: failing.schedule };
  return session.history.peek() === session.loaded.peek() ? { moment } : undefined;
}

/** The link of the open program, at a place of its run. */
export function shareLink(place?: Place): string {
  const lesson = source.lesson.peek();
  const { id, main, program, structured } = lesson;
  const shared: Shared = { lesson: id, files: source.files.peek(), program, main, ...place };
  if (structured) shared.structured = true;
  if (lessons.linked.peek().some((each) => each.id === id)) shared.own = lesson;
  return addressOf(shared);
}

/** Shows a link in another page. */
export function frameOf(link: string): string {
  const source = link.replaceAll("&", "&amp;");
  return `<iframe src="${source}" title="oncard" width="100%" height="640"></iframe>`;
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
