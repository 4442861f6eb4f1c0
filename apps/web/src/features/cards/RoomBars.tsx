/** The room that a phase of a manoeuvre needs, as a ruler, above the free room up to the block. */
import { useTranslation } from "react-i18next";
import styles from "./cards.module.css";

interface RoomBarsProps {
  needsLabel: string;
  freeLabel: string;
  /** cm */
  needs: number;
  /** cm, less than `needs` */
  free: number;
  /** both, as the sentences of the card display them */
  text: { needs: string; reading: string };
}

/** Distance between the marks of the ruler, in cm. */
const MARK_EVERY = 10;

export function RoomBars({ needsLabel, freeLabel, needs, free, text }: RoomBarsProps) {
  const { t } = useTranslation();
  const cm = (number: string) => t("cards.bump.cm", { number });
  const marks = Math.ceil(needs / MARK_EVERY) - 1;
  return (
    <dl className={styles["room"]}>
      <dt>{needsLabel}</dt>
      <dd>{cm(text.needs)}</dd>
      <div className={styles["needs"]} aria-hidden="true">
        {Array.from({ length: marks }, (_, at) => (
          <i key={at} style={{ insetInlineStart: `${((at + 1) * MARK_EVERY * 100) / needs}%` }} />
        ))}
      </div>
      <dt>{freeLabel}</dt>
      <dd className={styles["lacking"]}>{cm(text.reading)}</dd>
      <div className={styles["free"]} aria-hidden="true">
        <span style={{ inlineSize: `${Math.min(100, (free * 100) / needs)}%` }} />
        <i />
      </div>
    </dl>
  );
}
