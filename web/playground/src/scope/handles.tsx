// The handles at the right edge of the screen: where the zeros of the channels and the level of the
// trigger are.

import { divisions } from "./channels.js";
import { columnsOf } from "./columns.js";
import { handleSize, onScreen } from "./handle.js";
import { Level, placeOfLevel } from "./level.js";
import { drawn } from "./settings.js";
import type { Sweep } from "./trigger.js";
import { Zero } from "./zero.js";

/** @param height of all divisions, in pixels */
export function Handles({ sweep, height }: { sweep: Sweep; height: number }) {
  // Digital channels have a lane instead of a zero.
  const zeros = drawn.value.flatMap((setting, index) =>
    setting.isDigital ? [] : [{ setting, index }],
  );
  const level = placeOfLevel(sweep);
  const heights = [...zeros.map(({ setting }) => setting.offset), ...(level ? [level.at] : [])];
  const columns = columnsOf(heights.map(onScreen), (handleSize / height) * 2 * divisions);
  return (
    <>
      {zeros.map(({ setting, index }, order) => (
        <Zero
          key={setting.name}
          setting={setting}
          index={index}
          height={height}
          beside={columns[order] ?? 0}
        />
      ))}
      {level && <Level place={level} height={height} beside={columns[zeros.length] ?? 0} />}
    </>
  );
}
