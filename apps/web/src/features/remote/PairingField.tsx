/**
 * A short code that the user types where the script runs, in place of the long address. Also
 * displays the question of a script that used it.
 */
import { useEffect, useRef } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { Button } from "../../ui/Button.tsx";
import { classNames } from "../../ui/class-names.ts";
import type { RemoteSession } from "../../simulator/protocol/worker-messages.ts";
import { groupedCode, timeText } from "./pairing-text.ts";
import { newsText, questionText } from "./pairing-words.ts";
import { pairingOf } from "./robot-pairing.ts";
import { useTimeLeft } from "./use-time-left.ts";
import panel from "./remote.module.css";
import labels from "../../ui/field.module.css";
import fields from "./fields.module.css";
import styles from "./pairing-field.module.css";

/** Minimum share of the field that counts as in view. */
const ENOUGH = 0.95;

export function PairingField({ session }: { session: RemoteSession }) {
  const { t } = useTranslation();
  const pairing = pairingOf(session);
  const view = useStore(pairing.store, (state) => state.view);
  const field = useRef<HTMLElement>(null);
  useEffect(() => void pairing.resume(), [pairing]);
  useEffect(() => {
    const element = field.current;
    if (element === null) return;
    pairing.store.setState({ field: element });
    const watch = new IntersectionObserver(
      // Less than the whole field: a fraction of a pixel can be cut off.
      (entries) =>
        pairing.store.setState({ isInSight: (entries.at(-1)?.intersectionRatio ?? 0) >= ENOUGH }),
      { threshold: ENOUGH },
    );
    watch.observe(element);
    return () => {
      watch.disconnect();
      pairing.store.setState({ field: null, isInSight: false });
    };
  }, [pairing]);
  const isShown = view.kind === "open" || view.kind === "asked";
  /** Moves the focus from the pressed button, which is gone, to the button in its place. */
  const press = async (work: Promise<void>): Promise<void> => {
    await work;
    if (document.activeElement === document.body) field.current?.querySelector("button")?.focus();
  };
  return (
    <>
      <dt className={labels["label"]}>{t("remote.pair.title")}</dt>
      <dd ref={field} className={classNames(isShown && styles["pairing"])}>
        {view.kind === "open" && <Code code={view.code} />}
        <output className={classNames(view.kind === "asked" && styles["question"])}>
          {view.kind === "asked" && questionText(t, view.question)}
        </output>
        {isShown ? (
          <div className={styles["answers"]}>
            {view.kind === "asked" && (
              <Button kind="primary" size="large" onClick={() => void press(pairing.accept())}>
                {t("remote.pair.yes")}
              </Button>
            )}
            <Button
              size={view.kind === "asked" ? "large" : "small"}
              onClick={() => void press(pairing.decline())}
            >
              {view.kind === "asked" ? t("remote.pair.no") : t("remote.pair.cancel")}
            </Button>
          </div>
        ) : (
          <Button size="small" className={panel["long"]} onClick={() => void pairing.open()}>
            {t("remote.pair.make")}
          </Button>
        )}
      </dd>
      <dd className={fields["fieldNote"]}>
        <p>
          <output>{newsText(t, view)}</output>
          {view.kind === "open" && view.trouble === null && <TimeLeft endsAt={view.endsAt} />}
          {(view.kind === "none" || view.kind === "over") &&
            view.trouble === null &&
            t("remote.pair.note")}
        </p>
      </dd>
    </>
  );
}

/** Screen readers spell the code letter by letter. */
function Code({ code }: { code: string }) {
  return (
    <p dir="ltr" className={styles["pairingCode"]}>
      <span aria-hidden="true">{groupedCode(code)}</span>
      <span className="visually-hidden">{code.split("").join(" ")}</span>
    </p>
  );
}

function TimeLeft({ endsAt }: { endsAt: number }) {
  const { t } = useTranslation();
  const seconds = useTimeLeft(endsAt);
  return t("remote.pair.left", { time: timeText(seconds) });
}
