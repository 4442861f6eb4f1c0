/** One student: live picture, program, attempts by failure, and how the teacher can help. */
import { KeyRound, Lightbulb, Monitor, UserX, X } from "lucide";
import { useEffect, useRef, useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useShallow } from "zustand/react/shallow";
import { shownCode } from "../../model/classes/shown-code.ts";
import { verificationOf } from "../../model/classroom/dashboard.ts";
import { openTask, openWork } from "../../model/classroom/standing.ts";
import type { CountedFailure, SeenStudent } from "../../simulator/protocol/classroom-messages.ts";
import { directionOf } from "../../text/direction.ts";
import { Button, IconButton } from "../../ui/Button.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { CardClock, useMinutes } from "./CardClock.tsx";
import { useContent, useDashboard, useStudentName } from "./dashboard-context.ts";
import { ProgramText } from "./ProgramText.tsx";
import { StandingChip } from "./StandingChip.tsx";
import { PictureArea, StudentPicture } from "./StudentPicture.tsx";
import { cardState, cardTime } from "./use-card.ts";
import styles from "./watch-sheet.module.css";

interface WatchSheetProps {
  /** number of the student */
  student: number;
  /** whether the run of the student is on the big screens */
  isOnScreens: boolean;
  onScreens: (isShown: boolean) => void;
  onClose: () => void;
}

export function WatchSheet(props: WatchSheetProps) {
  const { student: number, isOnScreens, onScreens, onClose } = props;
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { dashboard } = useContent();
  const student = useDashboard(({ students }) => students.get(number));
  const sheet = useRef<HTMLElement>(null);
  const isGone = student === undefined;
  useEffect(() => {
    dashboard.send({ type: "watch", student: number });
    sheet.current?.focus();
    return () => {
      dashboard.send({ type: "watch", student: null });
      document.querySelector<HTMLElement>(`[data-student="${number}"]`)?.focus();
    };
  }, [dashboard, number]);
  useEffect(() => {
    if (isGone) onClose();
  }, [isGone, onClose]);
  if (student === undefined) return null;
  return (
    // oxlint-disable-next-line jsx-a11y/no-noninteractive-element-interactions -- Escape closes it
    <aside
      ref={sheet}
      className={styles["sheet"]}
      tabIndex={-1}
      aria-labelledby="watched-student"
      onKeyDown={(event) => {
        if (event.key !== "Escape") return;
        event.stopPropagation();
        onClose();
      }}
    >
      <SheetHead student={student} onClose={onClose} />
      <PictureArea className={styles["stage"]}>
        <StudentPicture student={number} />
      </PictureArea>
      <Unverified student={student} />
      <ProgramText student={student} />
      <Attempts student={student} />
      <Actions student={student} label={t("watch.actions")}>
        <Button icon={<Icon of={Monitor} />} onClick={() => onScreens(!isOnScreens)}>
          {isOnScreens ? t("screen.hide") : t("screen.show")}
        </Button>
      </Actions>
    </aside>
  );
}

function SheetHead({ student, onClose }: { student: SeenStudent; onClose: () => void }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const nameOf = useStudentName();
  const state = useDashboard((all) => cardState(all, student));
  const time = useDashboard(useShallow((all) => cardTime(all, student)));
  const minutes = useMinutes(time);
  return (
    <div className={styles["head"]}>
      <h2 id="watched-student" className={styles["name"]} dir="auto">
        {nameOf(student)}
      </h2>
      {/* The sheet has its own sentence for it. */}
      {state !== "unverified" && <StandingChip state={state} />}
      <span className={styles["time"]}>
        <span aria-hidden="true">
          <CardClock {...time} />
        </span>
        <span className="visually-hidden">{t("card.minutes", { count: minutes })}</span>
      </span>
      <IconButton label={t("close")} size="medium" onClick={onClose}>
        <Icon of={X} />
      </IconButton>
    </div>
  );
}

function Unverified({ student }: { student: SeenStudent }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const isUnverified = useDashboard((all) => verificationOf(all, student)?.kind === "fails");
  return isUnverified && <p className={styles["wrong"]}>{t("watch.unverified")}</p>;
}

/** How often each failure ended an attempt at the open task. */
function Attempts({ student }: { student: SeenStudent }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const work = openWork(student);
  const failureText = ({ code, line }: CountedFailure): string => {
    const what = code === "bump" ? t("failure.bump") : t(`failure.${failureKey(code)}`);
    if (line === null) return what;
    return line === "default"
      ? t("failure.otherwise", { what })
      : t("failure.line", { what, line: line + 1 });
  };
  return (
    <section className={styles["part"]}>
      <h3 className={styles["heading"]}>{t("card.attempts", { count: work?.attempts ?? 0 })}</h3>
      <ul className={styles["failures"]}>
        {(work?.failures ?? []).map((failure) => (
          <li key={`${failure.code} ${failure.line}`}>
            <span>{failureText(failure)}</span>
            <strong>{failure.count}</strong>
          </li>
        ))}
      </ul>
    </section>
  );
}

const goalFailures: ReadonlySet<string> = new Set([
  "not-reached",
  "not-visited",
  "not-stopped",
  "too-short",
]);

function failureKey(code: string): "goal" | "rules" {
  return goalFailures.has(code) ? "goal" : "rules";
}

/** What the student will read, before the teacher shows it. */
function NextHint({ hint, text }: { hint: number; text: string }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const language = useDashboard(({ lesson }) => lesson?.language ?? null);
  return (
    <p id="next-hint" className={styles["hint"]}>
      <strong>{t("watch.hintNext", { hint })}</strong>{" "}
      <span lang={language ?? undefined} dir={directionOf(language)}>
        {text}
      </span>
    </p>
  );
}

interface ActionsProps {
  student: SeenStudent;
  label: string;
  /** more buttons */
  children: ReactNode;
}

function Actions({ student, label, children }: ActionsProps) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { dashboard, calls, report } = useContent();
  const nameOf = useStudentName();
  const task = openTask(student);
  const hints = useDashboard(({ lesson }) => lesson?.tasks[task - 1]?.words.hints);
  const [shown, setShown] = useState<ReadonlyMap<number, number>>(new Map());
  const [code, setCode] = useState<string | null>(null);
  const [isRemoving, setRemoving] = useState(false);
  const count = hints?.length ?? 0;
  const seen = Math.max(openWork(student)?.hints ?? 0, shown.get(task) ?? 0);
  const next = Math.min(count, seen + 1);
  const showHint = (): void => {
    dashboard.send({ type: "hint", student: student.student, task, hint: next });
    setShown(new Map(shown).set(task, next));
  };
  const returnCode = async (): Promise<void> => {
    const found = await calls.returnCode(student.student);
    if (found === null) report("offline");
    else setCode(found.code);
  };
  return (
    <section className={styles["part"]} aria-label={label}>
      {count > 0 && <NextHint hint={next} text={hints?.[next - 1] ?? ""} />}
      <div className={styles["actions"]}>
        {count > 0 && (
          <Button
            icon={<Icon of={Lightbulb} />}
            disabled={!student.isConnected}
            aria-describedby="next-hint"
            onClick={showHint}
          >
            {t(seen < count ? "watch.hint" : "watch.hintAgain", { hint: next })}
          </Button>
        )}
        {children}
        <Button icon={<Icon of={KeyRound} />} onClick={() => void returnCode()}>
          {t("watch.return")}
        </Button>
        <Button icon={<Icon of={UserX} />} onClick={() => setRemoving(!isRemoving)}>
          {t("watch.remove")}
        </Button>
      </div>
      <output className={styles["said"]}>
        {(shown.get(task) ?? 0) > 0 && <p>{t("watch.hintShown", { hint: shown.get(task) })}</p>}
        {code !== null && (
          <p>
            {t("watch.returnText")}{" "}
            <strong className={styles["letters"]} dir="ltr">
              {shownCode(code)}
            </strong>
          </p>
        )}
      </output>
      {isRemoving && (
        <div className={styles["question"]}>
          <p>{t("watch.removeText", { name: nameOf(student) })}</p>
          <Button kind="primary" onClick={() => void calls.remove(student.student).then(report)}>
            {t("watch.remove")}
          </Button>
        </div>
      )}
    </section>
  );
}
