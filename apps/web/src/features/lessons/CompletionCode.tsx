/**
 * The completion code of a solved task, for the teacher: to copy, to show as a QR code, or to send
 * with the device's own share sheet.
 */
import { lessonMark, type Attempt, type LessonDocument } from "@corridor/challenge";
import { attemptOf, encodeLink } from "@corridor/link";
import type { RunDocument } from "@corridor/recording";
import type { DriverName } from "@corridor/protocol";
import { QrCode as QrIcon } from "lucide";
import { useEffect, useMemo, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { mazeCount } from "../../model/challenge/challenge-store.ts";
import { saveRun } from "../../model/run/run-requests.ts";
import { useServices } from "../../model/use-services.ts";
import { Button } from "../../ui/Button.tsx";
import { CopyButton } from "../../ui/CopyButton.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { QrCode } from "../../ui/QrCode.tsx";
import { qrPath } from "../../ui/qr-path.ts";
import { ShareSheetButton } from "../../ui/ShareSheetButton.tsx";
import styles from "./completion-code.module.css";

interface CompletionCodeProps {
  lesson: LessonDocument;
  /** index of the solved task */
  task: number;
  /** who solved it */
  driver: DriverName;
}

export function CompletionCode({ lesson, task, driver }: CompletionCodeProps) {
  const { t } = useTranslation(["missions", "words"], { useSuspense: false });
  const attempt = useAttempt(driver);
  const code = useMemo(
    () => (attempt ? codeOf(lesson, task, attempt) : null),
    [lesson, task, attempt],
  );
  const text = useRef<HTMLElement>(null);
  const [isQrShown, setQrShown] = useState(false);
  const [isByHand, setByHand] = useState(false);
  if (attempt === undefined) return null;
  if (driver !== "program" && mazeCount(lesson.tasks[task] ?? null) > 1) {
    return <p className={styles["note"]}>{t("missions:code.oneDrive")}</p>;
  }
  if (attempt === null) return <p className={styles["note"]}>{t("missions:code.mixed")}</p>;
  if (code === null) return <p className={styles["note"]}>{t("missions:code.tooLong")}</p>;
  const qr = isQrShown ? qrPath(code) : null;
  return (
    <section className={styles["completion"]} aria-label={t("missions:code.title")}>
      <p className={styles["line"]}>
        {t("missions:code.title")}{" "}
        <code ref={text} dir="ltr" className={styles["code"]}>
          {code}
        </code>
      </p>
      <div className={styles["buttons"]}>
        <CopyButton
          text={code}
          label={t("missions:code.copy")}
          done={t("missions:code.copied")}
          kind="outline"
          size="small"
          onRefused={() => {
            if (text.current !== null) getSelection()?.selectAllChildren(text.current);
            setByHand(true);
          }}
        />
        <Button
          size="small"
          icon={<Icon of={QrIcon} />}
          aria-expanded={isQrShown}
          onClick={() => setQrShown(!isQrShown)}
        >
          {t("missions:code.qr")}
        </Button>
        <ShareSheetButton size="small" data={{ text: code }} label={t("missions:code.send")} />
      </div>
      {qr !== null && <QrCode code={qr} />}
      <p className={styles["note"]}>
        {t("missions:code.note")} {isByHand && t("words:share.copyByHand")}
      </p>
    </section>
  );
}

/**
 * The program, or the commands of the drive; null if a program drove in part, undefined until it is
 * known.
 */
function useAttempt(driver: DriverName): Attempt | null | undefined {
  const { workspace, simulator } = useServices();
  const program = useStore(workspace, (state) => state.program);
  const [drive, setDrive] = useState<Attempt | null>();
  useEffect(() => {
    if (driver === "program") return;
    return saveRun(simulator, (answer) => {
      if (answer.ok) setDrive(attemptOf(JSON.parse(answer.text) as RunDocument));
    });
  }, [simulator, driver]);
  return driver === "program" ? program : drive;
}

/** @returns null if the attempt is too long for a code */
function codeOf(lesson: LessonDocument, task: number, attempt: Attempt): string | null {
  const encoded = encodeLink({ completion: { lesson: lessonMark(lesson), task, attempt } });
  return encoded.ok ? encoded.text : null;
}
