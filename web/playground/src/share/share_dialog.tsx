// The link of the open project, at its start or where its run is, a frame with it for other pages, and a
// picture and a video of the run.

import { useState } from "preact/hooks";

import { Dialog } from "../panel/dialog.js";
import { present } from "../session/bench.js";
import { texts } from "../texts/texts.js";
import { RunPicture } from "../video/run_picture.js";
import { CopyableLink } from "./copyable_link.js";
import { frameOf, presentPlace, shareLink } from "./project_link.js";

export function ShareDialog({ onClose }: { onClose: () => void }) {
  return (
    <Dialog title={texts.value.share.title} onClose={onClose}>
      <div class="share">
        <Links />
        <RunPicture />
      </div>
    </Dialog>
  );
}

function Links() {
  const { share: t } = texts.value;
  const [place] = useState(presentPlace);
  const [isHere, setHere] = useState(place?.recording !== undefined);
  const link = shareLink(isHere ? place : undefined);
  return (
    <div class="share-links">
      <p>{t.text}</p>
      {place ? (
        <label class="row">
          <input
            type="checkbox"
            checked={isHere}
            onChange={({ currentTarget }) => {
              setHere(currentTarget.checked);
            }}
          />
          {t.here(place.moment)}
        </label>
      ) : (
        (present.state.value?.moment ?? 0) > 0 && <p class="muted">{t.notHere}</p>
      )}
      <CopyableLink label={t.link} link={link} />
      {!link.startsWith("#") && <CopyableLink label={t.frame} link={frameOf(link)} />}
    </div>
  );
}
