/** Below the maze: the scale, and the position of the robot. */
import { useMemo } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import type { RunState } from "../../model/run/run-store.ts";
import { preparePhrase } from "../../text/phrase.ts";
import { LiveText } from "../../ui/LiveText.tsx";
import { memoize } from "../../ui/memoize.ts";
import { DescribeButton } from "./DescribeButton.tsx";
import { deferredPart } from "../../ui/lazy-part.tsx";
import { facingOf, type Facing } from "../../stage/page/robot-place.ts";
import type { StageViewStore } from "../../stage/page/stage-view.ts";
import { scaleBar } from "../../stage/page/scale-bar.ts";
import styles from "./stage.module.css";

/** Loads at once if the maze is larger than the stage. The keys for zooming work without it. */
const ZoomButtons = deferredPart(async () => (await import("./ZoomButtons.tsx")).ZoomButtons);

export function StageLegend({ view }: { view: StageViewStore }) {
  const { t } = useTranslation();
  const { run } = useServices();
  const isDivided = useStore(view, ({ layout }) => layout !== null);
  const overflows = useStore(view, ({ layout }) => layout?.overflows === true);
  const isKnown = useStore(run, ({ snapshot }) => snapshot !== null);
  const isNow = useStore(run, (state) => state.view === "now");
  return (
    <div className={styles["legend"]} data-ready={isDivided && isKnown} data-now={isNow}>
      <ScaleBar view={view} />
      <span className={styles["block"]}>{t("stage.block")}</span>
      <div className={styles["zoom"]}>
        <ZoomButtons size="small" isWanted={overflows} />
      </div>
      <RobotPlace />
      <DescribeButton className={styles["describe"]} />
    </div>
  );
}

/**
 * Screen readers can read the position, but do not announce its changes, unlike bumps and goals.
 */
function RobotPlace() {
  const { run } = useServices();
  const { t } = useTranslation();
  const text = useMemo(() => {
    const phrase = preparePhrase(["x", "y", "facing"], (marks) => t("stage.robotAt", marks));
    const facingText = memoize((facing: Facing) => t(`stage.facing.${facing}`));
    return ({ snapshot }: RunState): string => {
      if (snapshot === null) return "";
      const { x, y, heading } = snapshot.pose;
      const facing = facingText(facingOf(heading));
      return phrase({ x: Math.round(x), y: Math.round(y), facing });
    };
  }, [t]);
  const isKnown = useStore(run, ({ snapshot }) => snapshot !== null);
  if (!isKnown) return null;
  return (
    <span className={styles["place"]}>
      <LiveText of={run} text={text} className="live-box" />
    </span>
  );
}

function ScaleBar({ view }: { view: StageViewStore }) {
  const { t } = useTranslation();
  const cellPx = useStore(view, ({ layout }) => layout?.cellPx ?? 0);
  if (cellPx === 0) return null;
  const { units, width, ticks } = scaleBar(cellPx);
  return (
    <svg className={styles["scale"]} width={width + 40} height={28} aria-hidden="true">
      <rect className={styles["scaleFill"]} x={1} y={1} width={width / 2} height={5} />
      <rect className={styles["scaleFrame"]} x={1} y={1} width={width} height={5} />
      <path
        className={styles["scaleFrame"]}
        d={ticks.map((x, at) => `M${x + 1} 8v${at % 5 === 0 ? 4 : 2}`).join("")}
      />
      <text x={1} y={24}>
        0
      </text>
      <text x={1 + width / 2} y={24} className={styles["scaleMiddle"]}>
        {units / 2}
      </text>
      <text x={width - 8} y={24}>
        {t("stage.cm", { number: units })}
      </text>
    </svg>
  );
}
