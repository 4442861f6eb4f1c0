/** The name that the student has in the class, and the way into the student's page. */
import type { JoinedClass } from "@corridor/protocol";
import { useEffect, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { studentNameText } from "../../model/classes/student-name.ts";
import { Button } from "../../ui/Button.tsx";
import buttons from "../../ui/button.module.css";
import { classNames } from "../../ui/class-names.ts";
import { FieldError } from "../../ui/FieldError.tsx";
import type { RenameAnswer } from "./request-name.ts";
import styles from "./join.module.css";

const problemKeys = {
  refused: "inClass.noOtherName",
  offline: "problem.offline",
  removed: "inClass.removed",
  replaced: "inClass.replaced",
  over: "inClass.over",
} as const;

interface JoinedClassCardProps {
  joined: JoinedClass;
  onRename: (renamed: JoinedClass) => void;
}

export function JoinedClassCard({ joined, onRename }: JoinedClassCardProps) {
  const { t } = useTranslation("join", { useSuspense: false });
  const { t: tNames } = useTranslation("names", { useSuspense: false });
  const title = useRef<HTMLHeadingElement>(null);
  // The form is gone: the focus moves to what replaced it.
  useEffect(() => title.current?.focus(), []);
  return (
    <section className={styles["card"]}>
      <h1 ref={title} className={styles["title"]} tabIndex={-1} aria-live="polite" aria-atomic>
        {t("youAre")}{" "}
        <bdi className={styles["name"]}>{studentNameText(tNames, joined.name)}</bdi>
      </h1>
      <p className={styles["text"]}>{t("noAccount")}</p>
      <p className={styles["text"]}>{t("ownMazes")}</p>
      <div className={styles["actions"]}>
        <OtherName joined={joined} onRename={onRename} />
        <a className={classNames(buttons["button"], buttons["primary"], buttons["large"])} href="/">
          {t("start")}
        </a>
      </div>
      <details className={styles["more"]}>
        <summary>{t("teacherSees")}</summary>
        <p className={styles["text"]}>{t("teacherSeesText")}</p>
      </details>
    </section>
  );
}

/** The part with the connection loads on demand. */
async function request(joined: JoinedClass): Promise<RenameAnswer> {
  try {
    const { requestName } = await import("./request-name.ts");
    return await requestName(joined, location.origin);
  } catch {
    return { ok: false, reason: "offline" };
  }
}

function OtherName({ joined, onRename }: JoinedClassCardProps) {
  const { t } = useTranslation("join", { useSuspense: false });
  /** null: not asked yet, or asking */
  const [answer, setAnswer] = useState<RenameAnswer | null>(null);
  const [isAsking, setAsking] = useState(false);
  const isUsedUp = answer?.ok === true ? answer.renamesLeft === 0 : answer?.reason === "refused";
  const ask = async (): Promise<void> => {
    // A second press must not use up the next change, too.
    if (isAsking || isUsedUp) return;
    setAsking(true);
    setAnswer(null);
    const received = await request(joined);
    if (received.ok) onRename({ ...joined, name: received.name });
    setAnswer(received);
    setAsking(false);
  };
  return (
    <>
      {answer?.ok === false && (
        <div className={styles["refusal"]}>
          <FieldError>{t(problemKeys[answer.reason])}</FieldError>
        </div>
      )}
      <Button size="large" aria-disabled={isAsking || isUsedUp} onClick={() => void ask()}>
        {answer?.ok === true
          ? t("inClass.otherName", { left: answer.renamesLeft })
          : t("otherName")}
      </Button>
    </>
  );
}
