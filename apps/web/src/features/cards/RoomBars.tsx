/** The room that a phase of a manoeuvre needs, as a ruler, above the free room up to the block. */
import { useTranslation } from "react-i18next";
import { roundedSides } from "../../text/compared.ts";
import { localNumber } from "../../text/numbers.ts";
import styles from "./cards.module.css";

interface RoomBarsProps {
  needsLabel: string;
  freeLabel: string;
  /** cm */
  needs: number;
  /** cm, less than `needs` */
  free: number;
}

/** Distance between the marks of the ruler, in cm. */
const MARK_EVERY = 10;

export function RoomBars({ needsLabel, freeLabel, needs, free }: RoomBarsProps) {
  const { t, i18n } = useTranslation();
  const shown = roundedSides({ left: free, is: "<", right: needs, isTrue: free < needs }, 0);
  const cm = (number: number) =>
    t("cards.bump.cm", { number: localNumber(String(number), i18n.language) });
  const marks = Math.ceil(needs / MARK_EVERY) - 1;
  return (
    <dl className={styles["room"]}>
      <dt>{needsLabel}</dt>
      <dd>{cm(shown.right)}</dd>
      <div className={styles["needs"]} aria-hidden="true">
        {Array.from({ length: marks }, (_, at) => (
          <i key={at} style={{ insetInlineStart: `${((at + 1) * MARK_EVERY * 100) / needs}%` }} />
        ))}
      </div>
      <dt>{freeLabel}</dt>
      <dd className={styles["lacking"]}>{cm(shown.left)}</dd>
      <div className={styles["free"]} aria-hidden="true">
        <span style={{ inlineSize: `${Math.min(100, (free * 100) / needs)}%` }} />
        <i />
      </div>
    </dl>
  );
}
