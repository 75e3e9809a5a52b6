// The link of the open project.

import { useState } from "preact/hooks";

import { Dialog } from "../panel/dialog.js";
import { texts } from "../texts/texts.js";
import { CopyableLink } from "./copyable_link.js";
import { shareLink } from "./project_link.js";

export function ShareDialog({ onClose }: { onClose: () => void }) {
  const { share: t } = texts.value;
  const [link] = useState(shareLink);
  return (
    <Dialog title={t.title} onClose={onClose}>
      <p>{t.text}</p>
      <CopyableLink link={link} />
    </Dialog>
  );
}
