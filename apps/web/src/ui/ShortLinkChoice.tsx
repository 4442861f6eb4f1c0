/** Makes a short link, and deletes what the service stores for it. */
import { Link2, Trash2 } from "lucide";
import { useTranslation } from "react-i18next";
import { Button } from "./Button.tsx";
import { Icon } from "./Icon.tsx";
import styles from "./short-link-choice.module.css";

interface ShortLinkChoiceProps {
  /** whether the short link of the shared content exists */
  isMade: boolean;
  isBusy: boolean;
  /** result of the last press */
  outcome: "made" | "failed" | "deleted" | "notDeleted" | null;
  /** why the content has no short link; null if it can have one */
  refusal: string | null;
  onMake: () => void;
  onDelete: () => void;
}

export function ShortLinkChoice({
  isMade,
  isBusy,
  outcome,
  refusal,
  onMake,
  onDelete,
}: ShortLinkChoiceProps) {
  const { t } = useTranslation();
  const isShown = isMade && refusal === null;
  // Before the user makes a link, the note explains who can open it.
  const note = refusal ?? t("share.shortLink.note");
  const said = outcome === null || refusal !== null ? "" : t(`share.shortLink.${outcome}`);
  // The button stays in place: a double click could hit a button that replaces it.
  return (
    <div className={styles["choice"]}>
      <Button
        icon={<Icon of={Link2} />}
        className={isShown ? styles["done"] : undefined}
        disabled={refusal !== null}
        aria-disabled={isBusy || isShown}
        onClick={onMake}
      >
        {t("share.shortLink.make")}
      </Button>
      {isShown && (
        <Button icon={<Icon of={Trash2} />} aria-disabled={isBusy} onClick={onDelete}>
          {t("share.shortLink.delete")}
        </Button>
      )}
      <p className={styles["note"]}>{note}</p>
      <output className={outcome === "made" ? "visually-hidden" : styles["note"]}>{said}</output>
    </div>
  );
}
