/**
 * The controls over the stage while the Drive tab of a phone is open: a button that switches
 * between the whole maze and the robot, and a small map while the camera shows only a part.
 */
import { CELL } from "@corridor/maze";
import { LocateFixed, Scan } from "lucide";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { Button } from "../../ui/Button.tsx";
import { classNames } from "../../ui/class-names.ts";
import { deferredPart } from "../../ui/lazy-part.tsx";
import { centredScroll, viewportAt, viewX, viewY } from "../../stage/drawing/viewport.ts";
import type { StageViewStore } from "../../stage/page/stage-view.ts";
import { cellBox } from "../../stage/layers/places.ts";
import { buttonSide, type Side } from "./button-side.ts";
import styles from "./camera-view.module.css";

/** Largest number of goals that the button avoids: a maze may be full of goals. */
const MAX_GOALS = 16;

const SmallMap = deferredPart(async () => (await import("./SmallMap.tsx")).SmallMap);

export function CameraView({ view }: { view: StageViewStore }) {
  const { t, i18n } = useTranslation();
  const { camera } = useServices();
  const isRightToLeft = i18n.dir() === "rtl";
  const isWhole = useStore(camera, (state) => state.isWhole);
  const follows = useStore(view, ({ layout }) => layout?.follows === true);
  const side = useButtonSide(view, isRightToLeft ? "left" : "right");
  // A maze that fits at the robot's scale is always displayed whole.
  if (!isWhole && !follows) return null;
  const icon = isWhole ? LocateFixed : Scan;
  return (
    <>
      <div
        className={classNames(styles["bar"], follows && styles["over"])}
        data-at={(side === "left") === isRightToLeft ? "end" : "start"}
      >
        <Button
          size="large"
          className={styles["look"]}
          icon={<Icon of={icon} />}
          onClick={() => camera.setState({ isWhole: !isWhole })}
        >
          {t(isWhole ? "phone.followRobot" : "phone.wholeMaze")}
        </Button>
      </div>
      {follows && <SmallMap isWanted view={view} />}
    </>
  );
}

/** The upper corner of the stage where the button covers neither a goal nor the robot. */
function useButtonSide(view: StageViewStore, preferred: Side): Side {
  const { run, workspace } = useServices();
  const layout = useStore(view, (state) => state.layout);
  const goals = useStore(workspace, ({ maze }) => maze.goals);
  return useStore(run, ({ snapshot }) => {
    if (layout === null || snapshot === null || !layout.follows) return preferred;
    const { x, y } = snapshot.pose;
    const viewport = viewportAt(layout, centredScroll(layout, x, y));
    // As large as a cell: the robot with the end of its trail.
    const side = layout.cellPx;
    const robot = {
      x: viewX(viewport, x - CELL / 2),
      y: viewY(viewport, y - CELL / 2),
      width: side,
      height: side,
    };
    const flags = goals.slice(0, MAX_GOALS).map((goal) => cellBox(viewport, goal));
    return buttonSide([robot, ...flags], layout.view, preferred);
  });
}
