// The bar at the top: transport, speed, clock, explore, share, language, and a menu for the rest.

import type { Ref } from "preact";
import { useRef, useState } from "preact/hooks";

import { layoutName } from "../frame/current.js";
import { Gallery } from "../lesson/gallery.js";
import { verdict } from "../lesson/checks.js";
import { Dialog } from "../panel/dialog.js";
import { session } from "../session/bench.js";
import { isEdited } from "../session/on_card.js";
import { openRecord, record } from "../session/record.js";
import { LessonDialog } from "../share/lesson_dialog.js";
import { ShareDialog } from "../share/share_dialog.js";
import { placesOf, resetPlaces } from "../store/places.js";
import { chooseLanguage, chooseTheme, settings, themes } from "../store/settings.js";
import { texts } from "../texts/texts.js";
import { type Action, actions, ariaKeys, keys, keyText } from "./actions.js";
import { Clock } from "./clock.js";
import { Menu } from "./menu.js";
import { Speed } from "./speed.js";

/** Drawings of 16 × 16. */
const icons = {
  run: "M4 2.5v11l9-5.5z",
  pause: "M4 2.5h3v11h-3zM9 2.5h3v11h-3z",
  start: "M1.5 2.5h2v11h-2zM9 2.5v11l-5-5.5zM14.5 2.5v11l-5-5.5z",
  step: "M3 2.5v11l7-5.5zM11 2.5h2v11h-2z",
  back: "M13 2.5v11l-7-5.5zM3 2.5h2v11h-2z",
  cycle: "M2 2.5v11l6-5.5zM8 2.5v11l6-5.5z",
  cycleBack: "M8 2.5v11l-6-5.5zM14 2.5v11l-6-5.5z",
};

function Tool({
  action,
  icon,
}: {
  action: Action & keyof typeof icons;
  icon?: keyof typeof icons;
}) {
  const { controls: t } = texts.value;
  const isPause = icon === "pause";
  const text = isPause ? t.pause : t[action];
  return (
    <button
      type="button"
      class={`tool ${action === "run" ? "primary" : ""}`}
      title={`${text} (${keyText(action)})`}
      aria-keyshortcuts={ariaKeys(action)}
      onClick={actions[action]}
    >
      <svg viewBox="0 0 16 16" aria-hidden="true">
        <path d={icons[icon ?? action]} />
      </svg>
      <span class={action === "run" ? "" : "visually-hidden"}>{text}</span>
    </button>
  );
}

export function Toolbar() {
  const { controls: t } = texts.value;
  const [shown, setShown] = useState<"keys" | "samples" | "share" | "teach" | undefined>(undefined);
  const { language, theme } = settings;
  // What was edited meanwhile is not what runs: Run loads it.
  const isRunning = session.notice.value.kind === "running" && !isEdited.value;
  const input = useRef<HTMLInputElement>(null);
  const close = () => {
    setShown(undefined);
  };
  return (
    <header class="toolbar">
      <h1>
        <Logo />
        oncard
      </h1>
      <div class="tools" role="toolbar" aria-label={t.all}>
        <div class="transport">
          <Tool action="start" />
          <Tool action="cycleBack" />
          <Tool action="back" />
          <Tool action="run" icon={isRunning ? "pause" : "run"} />
          <Tool action="step" />
          <Tool action="cycle" />
        </div>
        <Speed />
        <Clock />
        <button
          type="button"
          class="tool explore"
          disabled={verdict.value.kind === "busy" || record.value !== undefined}
          title={`${t.explore} (${keyText("explore")})`}
          aria-keyshortcuts={ariaKeys("explore")}
          onClick={actions.explore}
        >
          <svg viewBox="0 0 16 16" aria-hidden="true">
            <path d="M2 7h4l4-4h4v2h-3.200l-3 3 3 3h3.200v2h-4l-4-4h-4z" />
          </svg>
          <span class="tool-text">{t.explore}</span>
        </button>
      </div>
      <div class="row end">
        <button
          type="button"
          class="quiet"
          onClick={() => {
            setShown("share");
          }}
        >
          {t.share}
        </button>
        <button
          type="button"
          class="quiet"
          aria-label={texts.value.languageLabel}
          lang={language.value === "zh" ? "en" : "zh-CN"}
          onClick={() => {
            chooseLanguage(language.value === "zh" ? "en" : "zh");
          }}
        >
          {texts.value.language}
        </button>
        <Menu
          label={t.more}
          items={[
            {
              text: texts.value.welcome.samples,
              onChosen: () => {
                setShown("samples");
              },
            },
            { text: t.open, title: t.openRecord, onChosen: () => input.current?.click() },
            {
              text: t.teach,
              onChosen: () => {
                setShown("teach");
              },
            },
            {
              text: t.keys,
              onChosen: () => {
                setShown("keys");
              },
            },
            { text: texts.value.theme[theme.value], onChosen: chooseNextTheme },
            ...(hasOtherPlaces() ? [{ text: texts.value.frame.reset, onChosen: resetLayout }] : []),
          ]}
        />
      </div>
      <RecordInput input={input} />
      {shown === "keys" && <KeysDialog onClose={close} />}
      {shown === "samples" && (
        <Dialog title={texts.value.welcome.samples} onClose={close}>
          <Gallery onChosen={close} />
        </Dialog>
      )}
      {shown === "teach" && <LessonDialog onClose={close} />}
      {shown === "share" && <ShareDialog onClose={close} />}
    </header>
  );
}

/** Whether the reader has changed this layout; phones have none. */
function hasOtherPlaces(): boolean {
  const isPhone = matchMedia("(max-width: 760px)").matches;
  return !isPhone && Object.keys(placesOf(layoutName.value)).length > 0;
}

function resetLayout(): void {
  resetPlaces(layoutName.peek());
}

function chooseNextTheme(): void {
  const { theme } = settings;
  chooseTheme(themes[(themes.indexOf(theme.value) + 1) % themes.length] ?? "system");
}

function Logo() {
  return (
    <svg class="logo" viewBox="0 0 26 26" aria-hidden="true">
      <rect width="26" height="26" rx="7" />
      <path d="M4.500 18h4l3.200-9.500h4L19 18" />
      <circle cx="20" cy="18" r="3" />
    </svg>
  );
}

/** Opens a record that `oncard exec --record` has written. */
function RecordInput({ input }: { input: Ref<HTMLInputElement> }) {
  const { controls: t } = texts.value;
  return (
    <input
      ref={input}
      type="file"
      accept=".calls"
      hidden
      aria-label={t.openRecord}
      onChange={({ currentTarget }) => {
        const file = currentTarget.files?.[0];
        if (file) void file.text().then((text) => openRecord(file.name, text));
        currentTarget.value = ""; // the same file may be chosen again
      }}
    />
  );
}

function KeysDialog({ onClose }: { onClose: () => void }) {
  const { keys: t } = texts.value;
  const rows = [
    ...(Object.keys(keys) as Action[]).map((action) => [t[action], keyText(action)] as const),
    [t.describe, "F1"] as const,
    [t.complete, "Ctrl+Space"] as const,
    [t.tab, "Tab"] as const,
    [t.escape, "Esc"] as const,
    [t.others, "Esc"] as const,
  ];
  return (
    <Dialog title={t.title} onClose={onClose}>
      <table class="values">
        <tbody>
          {rows.map(([text, key]) => (
            <tr key={text}>
              <th scope="row">{text}</th>
              <td>
                <kbd>{key}</kbd>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </Dialog>
  );
}
