/** The lesson, how far the class is, and the code by which students join. */
import { useTranslation } from "react-i18next";
import { resultsTask } from "../../model/classroom/dashboard.ts";
import { Select } from "../../ui/Select.tsx";
import { useMediaQuery } from "../../ui/use-media-query.ts";
import { ClassCode } from "./ClassCode.tsx";
import { useContent, useDashboard } from "./dashboard-context.ts";
import styles from "./dashboard.module.css";

const MINUTE_MS = 60_000;

export function ClassHead({ name }: { name: string }) {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const isPhone = useMediaQuery("(max-width: 37.49em)");
  const hasStudents = useDashboard(({ students }) => students.size > 0);
  const language = useDashboard(({ lesson }) => lesson?.language ?? undefined);
  const minutes = useDashboard(({ classroom, now }) =>
    classroom === null ? 0 : Math.max(0, Math.floor((now - classroom.createdAt) / MINUTE_MS)),
  );
  const isLoaded = useDashboard(({ classroom }) => classroom !== null);
  return (
    <div className={styles["head"]} data-empty={!hasStudents}>
      <div className={styles["lesson"]}>
        <h1 className={styles["title"]} lang={language} dir="auto">
          {name}
        </h1>
        <p className={styles["facts"]}>
          <OpenTask />
          <Pace />
          {!isPhone && isLoaded && <span>{t("started", { count: minutes })}</span>}
          {isLoaded && <Joined />}
        </p>
      </div>
      {isLoaded && <ClassCode isLarge={!hasStudents} />}
    </div>
  );
}

function Joined() {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const joined = useDashboard(({ students }) => students.size);
  const expected = useDashboard(({ classroom }) => classroom?.expected ?? null);
  const isLocked = useDashboard(({ classroom }) => classroom?.settings.locked === true);
  if (expected !== null) {
    return <span>{t(isLocked ? "joinedOfLocked" : "joinedOf", { joined, expected })}</span>;
  }
  return (
    <span>
      {t("joined", { count: joined })} {isLocked && t("isLocked")}
    </span>
  );
}

/** The task of the results. */
function OpenTask() {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const task = useDashboard(resultsTask);
  const tasks = useDashboard(({ lesson }) => lesson?.tasks.length ?? 1);
  return tasks > 1 && <span>{t("summary.taskOf", { task, tasks })}</span>;
}

/** Which tasks students may open. */
function Pace() {
  const { t } = useTranslation("dashboard", { useSuspense: false });
  const { calls, report } = useContent();
  const tasks = useDashboard(({ lesson }) => lesson?.tasks.length ?? 1);
  const pace = useDashboard(({ classroom }) => classroom?.settings.paceTo ?? null);
  if (tasks < 2) return null;
  const options = Array.from({ length: tasks }, (_, at) => ({
    value: String(at + 1),
    label: at + 1 === tasks ? t("pace.all") : t("pace.to", { task: at + 1 }),
  }));
  const value = String(Math.min(pace ?? tasks, tasks));
  return (
    <Select
      label={t("pace.label")}
      value={value}
      options={options}
      onChange={(to) => void calls.setPace(Number(to) === tasks ? null : Number(to)).then(report)}
    />
  );
}
