/** The attempts of a student at the open task: how often each failure ended one, and the newest. */
import { useTranslation } from "react-i18next";
import { openWork } from "../../model/classroom/standing.ts";
import type {
  CountedFailure,
  RecentAttempt,
  SeenStudent,
} from "../../simulator/protocol/classroom-messages.ts";
import { classTimeText } from "./class-time-text.ts";
import styles from "./watch-sheet.module.css";

export function WatchedAttempts({ student }: { student: SeenStudent }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const failureText = useFailureText();
  const work = openWork(student);
  const recent = student.recent.filter(({ task }) => task === work?.task);
  return (
    <section className={styles["part"]}>
      <h3 className={styles["heading"]}>{t("card.attempts", { count: work?.attempts ?? 0 })}</h3>
      <ul className={styles["failures"]}>
        {(work?.failures ?? []).map((failure) => (
          <li key={`${failure.code} ${failure.line}`}>
            <span>{failureText(failure)}</span>
            <strong>{t("watch.times", { count: failure.count })}</strong>
          </li>
        ))}
      </ul>
      {recent.length > 0 && (
        <>
          <h3 className={styles["heading"]}>{t("watch.newest")}</h3>
          <ol className={styles["failures"]}>
            {recent.map((attempt) => (
              <li key={attempt.seq}>
                <AttemptText attempt={attempt} />
                <span dir="ltr">{classTimeText(attempt.at - (work?.openedAt ?? 0))}</span>
              </li>
            ))}
          </ol>
        </>
      )}
    </section>
  );
}

function AttemptText({ attempt: { check, failure } }: { attempt: RecentAttempt }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const failureText = useFailureText();
  const what = failure === null ? t("failure.none") : failureText(failure);
  return (
    <span>{check === null ? t("watch.run", { what }) : t("watch.check", { ...check, what })}</span>
  );
}

const goalFailures: ReadonlySet<string> = new Set([
  "not-reached",
  "not-visited",
  "not-stopped",
  "too-short",
  // The robot makes no progress.
  "stuck",
]);

/** Names why an attempt failed, and the line that caused it. */
function useFailureText(): (failure: Pick<CountedFailure, "code" | "line">) => string {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  return ({ code, line }) => {
    const what = code === "bump" ? t("failure.bump") : t(`failure.${failureKey(code)}`);
    if (line === null) return what;
    return line === "default"
      ? t("failure.otherwise", { what })
      : t("failure.line", { what, line: line + 1 });
  };
}

function failureKey(code: string): "goal" | "late" | "rules" {
  if (code === "late") return code;
  return goalFailures.has(code) ? "goal" : "rules";
}
