// The page: the bar, the status line and the panels. On narrow screens one panel is shown at a time.

import { StatusLine } from "./controls/status.js";
import { Toolbar } from "./controls/toolbar.js";
import { ProgramPanel } from "./editor/editor.js";
import { layoutName, reveal, wholePanel } from "./frame/current.js";
import { Frame, WholeButton } from "./frame/frame.js";
import { CloseButton } from "./frame/rail.js";
import { failingRun } from "./interleaving/failing_run.js";
import { InterleavingPanel } from "./interleaving/panel.js";
import { isOpening } from "./lesson/opening.js";
import { RecordPanel } from "./panel/record.js";
import { LessonPanel } from "./lesson/lesson_panel.js";
import { MachinePanel } from "./machine/panel.js";
import { ValuesPanel } from "./panel/values.js";
import { ScopePanel } from "./scope/scope.js";
import { present } from "./session/bench.js";
import { isEdited } from "./session/on_card.js";
import { record } from "./session/record.js";
import { forgetLink, openedLink } from "./share/opened_link.js";
import { layout, type Panel, panels, showPanel } from "./store/layout.js";
import { lessons } from "./store/lessons.js";
import { placesOf } from "./store/places.js";
import { settings } from "./store/settings.js";
import { texts } from "./texts/texts.js";
import { TimelinePanel } from "./timeline/timeline.js";

/** These show the card. */
const ofCard: readonly Panel[] = ["values", "machine", "timeline", "scope"];

function showsCard(name: Panel): boolean {
  return ofCard.includes(name) && !(name === "values" && layout.tab.value === "columns");
}

/** The record of a host takes the place of the program. */
function titleOf(name: Panel): string {
  const t = texts.value;
  return name === "program" && record.value ? t.record.title : t.panels[name];
}

function ContentOf({ name }: { name: Panel }) {
  switch (name) {
    case "lesson":
      return <LessonPanel />;
    case "program":
      return record.value ? <RecordPanel opened={record.value} /> : <ProgramPanel />;
    case "interleaving":
      return <InterleavingPanel />;
    case "machine":
      return <MachinePanel />;
    case "timeline":
      return <TimelinePanel />;
    case "scope":
      return <ScopePanel />;
    case "values":
      return <ValuesPanel />;
  }
}

function Box({ name }: { name: Panel }) {
  const title = titleOf(name);
  const height = placesOf(layoutName.value).heights?.[name];
  const isOutdated = showsCard(name) && isEdited.value && present.state.value !== undefined;
  return (
    <section
      class={[
        "panel",
        frontPanel() === name && "front",
        isOutdated && "outdated",
        wholePanel.value === name && "whole",
        height !== undefined && "high",
      ]
        .filter(Boolean)
        .join(" ")}
      ref={(element) => {
        element?.style.setProperty("--height", `${(100 * (height ?? 0)).toFixed(2)}%`);
      }}
      aria-labelledby={`panel-${name}`}
      id={name}
      tabIndex={-1}
    >
      <span class="panel-buttons">
        <CloseButton panel={name} title={title} />
        {name !== "lesson" && <WholeButton panel={name} title={title} />}
      </span>
      <h2 class="panel-title" id={`panel-${name}`}>
        {title}
      </h2>
      <ContentOf name={name} />
    </section>
  );
}

function boxOf(name: Panel) {
  return <Box name={name} />;
}

/** Without a failing run it has no panel; what it came from says why. */
function frontPanel(): Panel {
  const { value: front } = layout.front;
  return front === "interleaving" && !failingRun.value ? "lesson" : front;
}

export function App() {
  const t = texts.value;
  const failing = failingRun.value !== undefined;
  const shownPanels = panels.filter((name) => name !== "interleaving" || failing);
  return (
    <>
      <a
        class="skip"
        href="#program"
        onClick={(event) => {
          event.preventDefault();
          reveal("program");
          showPanel("program");
          requestAnimationFrame(() => {
            document.querySelector<HTMLElement>("#program > div button")?.focus();
          });
        }}
      >
        {t.skip}
      </a>
      <Toolbar />
      <StatusLine />
      <LinkMessage />
      <nav class="switcher" aria-label={t.panels.all}>
        {shownPanels.map((name) => (
          <button
            key={name}
            type="button"
            class="tab"
            aria-pressed={frontPanel() === name}
            onClick={() => {
              showPanel(name);
            }}
          >
            {titleOf(name)}
          </button>
        ))}
      </nav>
      <Frame
        class={`${isOpening.value ? "opening" : ""} ${failing ? "failing" : ""}`}
        titleOf={titleOf}
        boxOf={boxOf}
      />
    </>
  );
}

function LinkMessage() {
  const { share: t } = texts.value;
  const read = openedLink.link.value;
  const said = (() => {
    switch (read.kind) {
      case "shared":
        return t.opened;
      case "newer":
        return t.newer(read.version);
      case "foreign":
        return t.foreign;
      case "broken":
        return read.mistakes.length > 0 ? t.mistaken : t.broken;
      case "lesson":
        return lessons.all.value.some(({ id }) => id === read.id) ? "" : t.unknownLesson(read.id);
      case "none":
        return "";
    }
  })();
  if (said === "") return null;
  const mistakes = read.kind === "broken" ? read.mistakes : [];
  return (
    <div class="link-message" role="alert">
      <div class="grow">
        {said}
        {mistakes.length > 0 && (
          <ul>
            {mistakes.map(({ where, message }) => (
              <li key={where + message.en}>
                <code>{where}</code> {message[settings.language.value]}
              </li>
            ))}
          </ul>
        )}
      </div>
      <button type="button" class="quiet" onClick={forgetLink}>
        {texts.value.close}
      </button>
    </div>
  );
}
