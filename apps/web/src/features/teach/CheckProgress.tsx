/** The progress of the check, and the button that stops it. */
import { Square } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { groupedNumber } from "../../text/grouped-number.ts";
import { Button } from "../../ui/Button.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { ProgressStrip } from "../../ui/ProgressStrip.tsx";
import type { HandInCheck } from "./check-hand-ins.ts";
import styles from "./check-progress.module.css";

export function CheckProgress({ check }: { check: HandInCheck }) {
  const { t, i18n } = useTranslation("check", { useSuspense: false });
  const state = useStore(check.store, (each) => each.state);
  const done = useStore(check.store, (each) => each.done);
  const count = useStore(check.store, (each) => each.count);
  if (state === "idle") return null;
  const numbers = {
    done: groupedNumber(done, i18n.language),
    all: groupedNumber(count, i18n.language),
  };
  const sentence = t(`progress.${state}`, numbers);
  return (
    <div className={styles["progress"]}>
      <div className={styles["row"]}>
        <p className={styles["sentence"]}>{sentence}</p>
        {state === "running" && (
          <Button size="small" icon={<Icon of={Square} />} onClick={() => check.stop()}>
            {t("progress.stop")}
          </Button>
        )}
      </div>
      {state === "running" && (
        <ProgressStrip label={t("progress.label")} value={done} max={count} />
      )}
      {/* Announced once, at the end. */}
      <output className="visually-hidden">{state === "running" ? "" : sentence}</output>
    </div>
  );
}
