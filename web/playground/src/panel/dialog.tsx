// A question or a text above the page: the browser's own <dialog>, which keeps the focus.

import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";

import { texts } from "../texts/texts.js";

export function Dialog(props: {
  title: string;
  children: ComponentChildren;
  onClose: () => void;
  /** The answer that does something; without it there is only Close. */
  answer?: { text: string; onChosen: () => void };
}) {
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    dialog.current?.showModal();
  }, []);
  const { answer } = props;
  return (
    <dialog
      ref={dialog}
      class="dialog"
      aria-labelledby="dialog-title"
      onClose={props.onClose}
      onClick={(event) => {
        if (event.target === dialog.current) dialog.current?.close();
      }}
    >
      <h2 id="dialog-title">{props.title}</h2>
      {props.children}
      <div class="row end">
        <button type="button" onClick={() => dialog.current?.close()}>
          {answer ? texts.value.cancel : texts.value.close}
        </button>
        {answer && (
          <button
            type="button"
            class="primary"
            onClick={() => {
              dialog.current?.close();
              answer.onChosen();
            }}
          >
            {answer.text}
          </button>
        )}
      </div>
    </dialog>
  );
}
