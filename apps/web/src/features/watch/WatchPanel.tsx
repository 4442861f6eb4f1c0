/** Beside the stage: the state of the robot, its driver and its readings. */
import { List, RadioTower, User } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { facingOf } from "../../stage/page/robot-place.ts";
import { WatchReadings } from "./WatchReadings.tsx";
import { drivenBy, robotState, type WatchStore } from "./watch-store.ts";
import type { WatchClient } from "./watch-client.ts";
import { Checkbox } from "../../ui/Checkbox.tsx";
import { Icon } from "../../ui/Icon.tsx";
import styles from "./watch.module.css";

const icons = {
  me: <Icon of={User} />,
  program: <Icon of={List} isDirectional />,
  remote: <Icon of={RadioTower} />,
  waiting: <Icon of={RadioTower} />,
};

interface WatchPanelProps {
  store: WatchStore;
  client: Pick<WatchClient, "showMarks">;
}

export function WatchPanel({ store, client }: WatchPanelProps) {
  const { t } = useTranslation(["words", "watch"], { useSuspense: false });
  const name = useStore(store, ({ maze }) => maze?.name ?? "");
  const bumps = useStore(store, ({ snapshot }) => snapshot?.bumps ?? 0);
  const state = useStore(store, robotState);
  const isSeen = state === "running" || state === "paused";
  return (
    <aside className={styles["panel"]} aria-label={t("watch:robot")}>
      <h2>
        <bdi>{name === "" ? t("watch:robot") : name}</bdi>
      </h2>
      <RobotStatus store={store} />
      <section className={styles["readings"]} aria-label={t("drive.sensors")} data-seen={isSeen}>
        <h3>
          {t("drive.sensors")} <span>{t("drive.cm")}</span>
        </h3>
        <WatchReadings store={store} />
        <RobotPlace store={store} />
      </section>
      <dl className={styles["facts"]}>
        <dt>{t("watch:bumps")}</dt>
        <dd>{bumps}</dd>
      </dl>
      <MarksSwitch store={store} client={client} />
      <p className={styles["note"]}>{t("watch:note")}</p>
    </aside>
  );
}

/** Offered once a script has marked cells. */
function MarksSwitch({ store, client }: WatchPanelProps) {
  const { t } = useTranslation();
  const hasMarks = useStore(store, (state) => state.hasMarks);
  const showsMarks = useStore(store, (state) => state.showsMarks);
  if (!hasMarks) return null;
  return (
    <Checkbox
      label={t("stage.showMarks")}
      checked={showsMarks}
      onChange={(isShown) => client.showMarks(isShown)}
    />
  );
}

/** Screen readers can read the position, but do not announce its changes. */
function RobotPlace({ store }: { store: WatchStore }) {
  const { t } = useTranslation();
  const pose = useStore(store, ({ snapshot }) => snapshot?.pose ?? null);
  if (pose === null) return null;
  const facing = t(`stage.facing.${facingOf(pose.heading)}`);
  const { x, y } = { x: Math.round(pose.x), y: Math.round(pose.y) };
  return <p className={styles["place"]}>{t("stage.robotAt", { x, y, facing })}</p>;
}

/** Screen readers announce changes of the state, the driver and the goal. */
function RobotStatus({ store }: { store: WatchStore }) {
  const { t } = useTranslation(["words", "watch"], { useSuspense: false });
  const state = useStore(store, robotState);
  const driver = useStore(store, drivenBy);
  const isAtGoal = useStore(store, ({ snapshot }) => snapshot?.goalReached === true);
  const isSeen = state === "running" || state === "paused";
  return (
    <output className={styles["status"]}>
      <span className={styles["state"]} data-state={state}>
        {t(`watch:states.${state}`)}
      </span>
      {isSeen && driver !== null && (
        <span className={styles["driver"]}>
          {icons[driver]}
          {t(`watch:drivers.${driver}`)}
        </span>
      )}
      {isSeen && isAtGoal && <span className={styles["goal"]}>{t("watch:atGoal")}</span>}
    </output>
  );
}
