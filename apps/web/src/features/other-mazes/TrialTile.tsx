/**
 * One maze that the program is tried in: its picture, its seed, and its outcome as a mark and a
 * word.
 */
import type { MazeDocument } from "@corridor/maze";
import { Check, Clock, X } from "lucide";
import { memo, useDeferredValue } from "react";
import { useTranslation } from "react-i18next";
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
}

const icons = { works: Check, bump: X, "time-limit": Clock } as const;

export const TrialTile = memo(function TrialTile({
  seed,
  result,
  picture,
  isStop,
  onOpen,
}: TrialTileProps) {
  const { t, i18n } = useTranslation("otherMazes", { useSuspense: false });
  // The outcome is displayed first, and the picture as soon as the page has time.
  const drawn = useDeferredValue(picture);
  const outcome = result?.outcome ?? null;
  const icon = outcome === null ? null : icons[outcome];
  const time = formatClock(result?.tick ?? 0, i18n.language);
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
        <span className={styles["picture"]}>{drawn !== null && <MazePicture maze={drawn} />}</span>
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
