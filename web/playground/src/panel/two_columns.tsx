// The open program beside what it becomes on the card; it follows every edit.

import { RefusedError } from "@oncard/engine";

import { bench, present } from "../session/bench.js";
import { useAsked } from "../session/asked.js";
import { isEdited } from "../session/on_card.js";
import { isPointed, layout, pointAt, showLine } from "../store/layout.js";
import { source } from "../store/source.js";
import { texts } from "../texts/texts.js";
import { type Shown, shownAfter } from "../two_columns/shown.js";
import { TwoColumnsView } from "../two_columns/view.js";

/** Also of the time before, when another tab was in front. */
let last: Shown | undefined;

export function TwoColumns() {
  const project = source.project.value;
  const program = String(source.opened.value);
  const key = program + JSON.stringify(project);
  const ask = async () => {
    const answer = await (await bench.engine()).twoColumns(project).catch((error: unknown) => {
      if (error instanceof RefusedError) return undefined;
      throw error;
    });
    return (last = shownAfter(last, program, answer));
  };
  const shown = useAsked(key, ask, false) ?? last;
  if (shown?.program !== program) return null;
  const main = source.lesson.value.program;
  const next = isEdited.value ? [] : (present.state.value?.threads ?? []);
  const places = new Set(
    next.filter(({ state }) => state === "running").map(({ file, line }) => `${file}:${line}`),
  );
  return (
    <TwoColumnsView
      shown={shown}
      words={texts.value.twoColumns}
      mark={(file, line) => {
        if (places.has(`${file}:${line}`)) return "next";
        if (file === main && line === layout.chosenLine.value) return "linked";
        return isPointed(file, line) ? "pointed" : "";
      }}
      onPoint={(place) => {
        pointAt(place && { ...place, isInText: false });
      }}
      onShow={(file, line) => {
        if (file === main) showLine(line);
        else if (file in source.files.peek()) showLine(line, file);
      }}
    />
  );
}
