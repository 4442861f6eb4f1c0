/** The generated mazes in which the check runs a program, which students do not see before. */
import {
  mazeOf,
  MAX_UNSEEN_COUNT,
  MAX_UNSEEN_SEED,
  MAX_UNSEEN_SIDE,
  MIN_UNSEEN_SIDE,
} from "@corridor/challenge";
import { mazeKinds } from "@corridor/maze";
import { Dices } from "lucide";
import { useId, useMemo } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "../../../ui/Button.tsx";
import { Icon } from "../../../ui/Icon.tsx";
import { MazePicture } from "../../../ui/MazePicture.tsx";
import { Select } from "../../../ui/Select.tsx";
import { useDraft, useOpenTask } from "./draft-context.ts";
import styles from "./unseen-mazes.module.css";
import { BoundedNumber } from "./BoundedNumber.tsx";
import { withUnseen } from "./task-edits.ts";

/** Number of pictures. */
const PICTURES = 5;
const sides = Array.from(
  { length: (MAX_UNSEEN_SIDE - MIN_UNSEEN_SIDE) / 2 + 1 },
  (_, at) => `${MIN_UNSEEN_SIDE + 2 * at}`,
).map((value) => ({ value, label: value }));

export function UnseenMazes() {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  const draft = useDraft();
  const task = useOpenTask();
  const { unseen } = task;
  const titleId = useId();
  const change = (edit: Parameters<typeof withUnseen>[1], group: string | null = null) =>
    draft.setTask(withUnseen(draft.task, edit), group);
  return (
    <section className={styles["unseen"]} aria-labelledby={titleId}>
      <div className={styles["row"]}>
        <h3 id={titleId} className={styles["title"]}>
          {t("unseen.title")}
        </h3>
        <Select
          label={t("unseen.kind")}
          value={unseen?.kind ?? "none"}
          options={(["none", ...mazeKinds] as const).map((value) => ({
            value,
            label: t(`unseen.kinds.${value}`),
          }))}
          onChange={(kind) => {
            if (kind === "none") draft.editTask({ unseen: null });
            else change({ kind });
          }}
        />
        {unseen !== null && (
          <Button
            size="small"
            icon={<Icon of={Dices} />}
            onClick={() => change({ seed: Math.floor(Math.random() * (MAX_UNSEEN_SEED + 1)) })}
          >
            {t("unseen.another")}
          </Button>
        )}
      </div>
      <p className={styles["note"]}>{t("unseen.note")}</p>
      {unseen !== null && (
        <>
          <div className={styles["fields"]}>
            {(["columns", "rows"] as const).map((side) => (
              <label key={side} className={styles["side"]}>
                {t(`unseen.${side}`)}
                <Select
                  label={t(`unseen.${side}`)}
                  value={String(unseen[side])}
                  options={sides}
                  onChange={(length) => change({ [side]: Number(length) })}
                />
              </label>
            ))}
            <BoundedNumber
              label={t("unseen.seed")}
              value={unseen.seed}
              min={0}
              max={MAX_UNSEEN_SEED}
              onChange={(seed) => change({ seed }, "seed")}
            />
            <BoundedNumber
              label={t("unseen.count")}
              value={unseen.count}
              min={1}
              max={MAX_UNSEEN_COUNT}
              onChange={(count) => change({ count }, "count")}
            />
            <BoundedNumber
              label={t("unseen.pass")}
              value={unseen.pass}
              min={1}
              max={unseen.count}
              onChange={(pass) => change({ pass }, "pass")}
            />
          </div>
          <Pictures />
        </>
      )}
    </section>
  );
}

/** The first unseen mazes. */
function Pictures() {
  const task = useOpenTask();
  const { mazes, unseen } = task;
  const given = mazes.length;
  const first = useMemo(() => {
    const count = Math.min(PICTURES, unseen?.count ?? 0);
    return Array.from({ length: count }, (_, at) => mazeOf({ ...task, unseen }, given + at));
    // oxlint-disable-next-line react/exhaustive-deps -- the other fields do not change the mazes
  }, [unseen, given]);
  return (
    <ul className={styles["pictures"]} aria-hidden="true">
      {first.map((maze) => (
        <li key={maze.name} className={styles["picture"]}>
          <MazePicture maze={maze} />
        </li>
      ))}
    </ul>
  );
}
