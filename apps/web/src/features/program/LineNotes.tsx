/** What stands under a line while it is at work: how far its manoeuvre is, or the bump it came to. */
import { useTranslation } from "react-i18next";
import { BurstIcon } from "../timeline/BurstIcon.tsx";
import type { ShownBump, ShownProgress } from "./line-state.ts";
import styles from "./line-notes.module.css";

/** A bar that fills and the words to it: "turns in 36 cm". */
export function LineProgress({ progress }: { progress: ShownProgress }) {
  const { t } = useTranslation();
  const { kind, left, of } = progress;
  const words = t(`program.progress.${kind}`, { count: left });
  return (
    <div className={styles["progress"]}>
      <progress value={of - left} max={of} aria-label={words} />
      <span aria-hidden="true">{words}</span>
    </div>
  );
}

/** "bumped after 24 of 50 cm" */
export function LineBump({ bump }: { bump: ShownBump }) {
  const { t } = useTranslation();
  const { driven, needed } = bump;
  return (
    <p className={styles["bump"]}>
      <BurstIcon size={16} />
      {driven === null
        ? t("program.bumped.now")
        : needed === null
          ? t("program.bumped.after", { driven })
          : t("program.bumped.afterOf", { driven, needed })}
    </p>
  );
}
