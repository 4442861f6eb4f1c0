/** Makes a short link, and deletes what the service stores for it. */
import { Link2, Trash2 } from "lucide";
import { useTranslation } from "react-i18next";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import styles from "./share.module.css";
import type { ShortLinkState } from "./use-short-link.ts";

interface ShortLinkChoiceProps {
  short: ShortLinkState;
  /** the link includes a run, or a program with a challenge, which a short link does not carry */
  isMore: boolean;
}

export function ShortLinkChoice({ short, isMore }: ShortLinkChoiceProps) {
  const { t } = useTranslation();
  const { isOffered, link, isBusy, outcome } = short;
  if (!isOffered) return null;
  const isShown = link !== null && !isMore;
  // Before the student makes a link, the note explains who can open it.
  const note = t(isMore ? "share.shortLink.alone" : "share.shortLink.note");
  const said = outcome === null || isMore ? "" : t(`share.shortLink.${outcome}`);
  // The button stays in place: a double click could hit a button that replaces it.
  return (
    <div className={styles["short"]}>
      <Button
        icon={<Icon of={Link2} />}
        className={isShown ? styles["done"] : undefined}
        disabled={isMore}
        aria-disabled={isBusy || isShown}
        onClick={short.make}
      >
        {t("share.shortLink.make")}
      </Button>
      {isShown && (
        <Button icon={<Icon of={Trash2} />} aria-disabled={isBusy} onClick={short.remove}>
          {t("share.shortLink.delete")}
        </Button>
      )}
      <p className={styles["note"]}>{note}</p>
      <output className={outcome === "made" ? "visually-hidden" : styles["note"]}>{said}</output>
    </div>
  );
}
