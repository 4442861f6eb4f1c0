/**
 * One maze that the program is tried in: its picture, its seed, and its outcome as a mark and a
 * word.
 */
import type { MazeDocument } from "@corridor/maze";
import { Check, Clock, X } from "lucide";
import type { TFunction } from "i18next";
import { memo } from "react";
import { formatClock } from "../../text/numbers.ts";
import type { TrialResult } from "../../simulator/protocol/trial-messages.ts";
import { MazePicture } from "../../ui/MazePicture.tsx";
import { Icon } from "../../ui/Icon.tsx";
import styles from "./other-mazes.module.css";

interface TrialTileProps {
  seed: number;
  /** null: not tried yet */
  result: TrialResult | null;
  /** null: not drawn yet */
  picture: MazeDocument | null;
  /** whether this tile is the tab stop; arrow keys lead to the others */
  isStop: boolean;
  onOpen: (result: TrialResult) => void;
  /** from the grid, so that a hundred tiles do not subscribe to the language */
  t: TFunction<"otherMazes">;
  language: string;
}

const icons = { works: Check, bump: X, "time-limit": Clock } as const;

export const TrialTile = memo(function TrialTile({
  seed,
  result,
  picture,
  isStop,
  onOpen,
  t,
  language,
}: TrialTileProps) {
  const outcome = result?.outcome ?? null;
  const icon = outcome === null ? null : icons[outcome];
  const time = formatClock(result?.tick ?? 0, language);
  return (
    <li className={styles["item"]}>
      <button
        type="button"
        className={styles["tile"]}
        data-outcome={outcome ?? undefined}
        aria-label={t(`tile.${outcome ?? "waiting"}`, { seed, time })}
        aria-disabled={result === null}
        tabIndex={isStop ? 0 : -1}
        onClick={() => {
          if (result !== null) onOpen(result);
        }}
      >
        <span className={styles["picture"]}>
          {picture !== null && <MazePicture maze={picture} />}
        </span>
        <span className={styles["caption"]}>
          <span className={styles["seed"]}>{seed}</span>
          {outcome !== null && icon !== null && (
            <span className={styles["outcome"]}>
              <Icon of={icon} size={12} strokeWidth={3} />
              {t(`outcome.${outcome}`)}
            </span>
          )}
        </span>
      </button>
    </li>
  );
});
