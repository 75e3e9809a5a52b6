// Variables, threads, the statements on the card beside the lines of the source, the source beside what
// it becomes, and warnings.

import { type ListedFunction, recordText, type Variable } from "@oncard/engine";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

import { Tabs } from "../controls/tabs.js";
import { bench, present, session } from "../session/bench.js";
import { isEdited } from "../session/on_card.js";
import { record } from "../session/record.js";
import { isPointed, layout, pointAt, showLine, showTab, type Tab, tabs } from "../store/layout.js";
import { source } from "../store/source.js";
import { number } from "../texts/number.js";
import { texts } from "../texts/texts.js";
import { TwoColumns } from "./two_columns.js";

export function ValuesPanel() {
  const { values: t } = texts.value;
  // A record of a host has no program in the editor.
  const shownTabs: readonly Tab[] = record.value ? tabs.filter((each) => each !== "columns") : tabs;
  const chosen = layout.tab.value;
  const tab = shownTabs.includes(chosen) ? chosen : "listing";
  const list = useRef<HTMLDivElement>(null);
  const wishes = layout.listWishes.value;
  useLayoutEffect(() => {
    if (wishes > 0) list.current?.focus();
  }, [wishes]);
  return (
    <div class="values-panel">
      <Tabs
        label={t.label}
        values={shownTabs}
        chosen={tab}
        nameOf={(each) => t.tabs[each]}
        onChoose={showTab}
      />
      <div class="scroll" ref={list} tabIndex={0} role="group" aria-label={t.tabs[tab]}>
        {tab === "columns" ? (
          <TwoColumns />
        ) : !present.state.value ? (
          <p class="muted empty">{t.idle}</p>
        ) : tab === "variables" ? (
          <Variables />
        ) : tab === "threads" ? (
          <Threads />
        ) : tab === "listing" ? (
          <Listing />
        ) : (
          <Warnings />
        )}
      </div>
    </div>
  );
}

function Variables() {
  const { values: t } = texts.value;
  const threads = present.state.value?.threads ?? [];
  return (
    <>
      <VariableTable title={t.globals} variables={present.globals.value} />
      {[...present.locals.value].map(([page, variables]) => {
        const functions = threads.filter((thread) => thread.page === page);
        const names = functions.map(({ function: name }) => name).join(", ");
        return <VariableTable key={page} title={t.locals(page, names)} variables={variables} />;
      })}
    </>
  );
}

function VariableTable({ title, variables }: { title: string; variables: Variable[] }) {
  const { values: t } = texts.value;
  return (
    <table class="values variables">
      <caption>{title}</caption>
      <tbody>
        {variables.length === 0 && (
          <tr>
            <td class="muted">{t.none}</td>
          </tr>
        )}
        {variables.map(({ path, type, value }) => (
          <tr key={path}>
            <th scope="row" title={path}>
              {path}
            </th>
            <td class="muted">{type}</td>
            <td class="number">
              {Array.isArray(value) ? (
                <span class="array">
                  {value
                    .slice(0, 64)
                    .map((each) => number(each))
                    .join(", ")}
                </span>
              ) : (
                <input
                  type="number"
                  step="any"
                  class="value number"
                  aria-label={t.change(path)}
                  value={number(value, 6)}
                  onChange={({ currentTarget }) => {
                    const to = currentTarget.valueAsNumber;
                    if (Number.isFinite(to)) void bench.write(path, to);
                  }}
                />
              )}
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** Leads to a line of the program. */
function LineLink({ line }: { line: number }) {
  return (
    <button
      type="button"
      class="link"
      onClick={() => {
        showLine(line);
      }}
    >
      {line}
    </button>
  );
}

function Threads() {
  const { values: t } = texts.value;
  return (
    <table class="values">
      <thead>
        <tr>
          <th scope="col">{t.thread}</th>
          <th scope="col">{t.function}</th>
          <th scope="col" class="number">
            {t.page}
          </th>
          <th scope="col" class="number">
            {t.line}
          </th>
          <th scope="col" class="number">
            {t.executed}
          </th>
          <th scope="col">{t.status}</th>
        </tr>
      </thead>
      <tbody>
        {present.state.value?.threads.map((thread) => (
          <tr key={thread.thread} class={thread.state === "faulted" ? "bad" : ""}>
            <th scope="row">{thread.thread}</th>
            <td>{thread.function}</td>
            <td class="number">{thread.page}</td>
            <td class="number">
              <LineLink line={thread.line} />
            </td>
            <td class="number">{thread.statements}</td>
            <td>
              {thread.status}
              {thread.refused && ` (${thread.refused})`}
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** What the card's supervisor warns of up to the present moment. */
function Warnings() {
  const { values: t } = texts.value;
  const warnings = present.state.value?.warnings ?? [];
  if (warnings.length === 0) return <p class="muted empty">{t.noWarnings}</p>;
  return (
    <table class="values">
      <thead>
        <tr>
          <th scope="col" class="number">
            {t.line}
          </th>
          <th scope="col">{t.warning}</th>
          <th scope="col" class="number">
            {t.time}
          </th>
        </tr>
      </thead>
      <tbody>
        {warnings.map(({ name, text, time_ms: ms, line }, index) => (
          <tr key={index}>
            <td class="number">{line !== undefined && <LineLink line={line} />}</td>
            <td>
              {text} <span class="tag warning">{name}</span>
            </td>
            <td class="number">{number(ms)}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** The next statement of each thread, as `function position`. */
function nextStatements(): Set<string> {
  const running = (present.state.value?.threads ?? []).filter(({ state }) => state === "running");
  return new Set(running.map(({ function: name, position }) => `${name} ${position}`));
}

function leaveLines(): void {
  pointAt(undefined);
}

function Listing() {
  const next = nextStatements();
  useEffect(() => leaveLines, []);
  return (
    <>
      {session.listing.value.map((listed) => (
        <FunctionListing key={listed.name} listed={listed} next={next} />
      ))}
    </>
  );
}

function FunctionListing({ listed, next }: { listed: ListedFunction; next: Set<string> }) {
  const { values: t } = texts.value;
  const file = source.lesson.value.program;
  return (
    <table class="values listing" onPointerLeave={leaveLines}>
      <caption>{listed.name}</caption>
      <thead>
        <tr>
          <th scope="col" class="number">
            {t.line}
          </th>
          <th scope="col">{t.statement}</th>
          <th scope="col">{t.words}</th>
        </tr>
      </thead>
      <tbody>
        {listed.statements.map(({ line, text, words }, index) => {
          const isLinked = !isEdited.value && line === layout.chosenLine.value;
          const isUnderPointer = !isEdited.value && isPointed(file, line);
          const isNext = next.has(`${listed.name} ${index}`);
          return (
            <tr
              key={index}
              class={`${isLinked ? "linked" : ""} ${isUnderPointer ? "pointed" : ""} ${isNext ? "next" : ""}`}
              onPointerEnter={() => {
                if (!isEdited.peek()) pointAt({ file, line, isInText: false });
              }}
            >
              <td class="number">
                <LineLink line={line} />
              </td>
              <td>
                <code>{text}</code>
              </td>
              <td class="words">
                <code>{recordText(words)}</code>
              </td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}
