/** The maze with the robot, the tools that edit it, and the legend. */
import { useEffect, useLayoutEffect, useRef, useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { deferredPart } from "../../ui/lazy-part.tsx";
import type { StageViewStore } from "../../stage/page/stage-view.ts";
import { MazeGrid } from "./MazeGrid.tsx";
import { StageController } from "./stage-controller.ts";
import { StageLegend } from "./StageLegend.tsx";
import { ToolStrip } from "./ToolStrip.tsx";
import styles from "./stage.module.css";

/** For a phone while its Drive tab is open. */
const CameraView = deferredPart(async () => (await import("./CameraView.tsx")).CameraView);

/** For a maze that is larger than the stage. */
const SmallMap = deferredPart(async () => (await import("./SmallMap.tsx")).SmallMap);

interface StageProps {
  /** whether the strip with the tools is above the maze */
  hasTools?: boolean;
  /** beside the tools: undo and redo; null without them */
  history: ReactNode;
  /** in the strip above the maze: the open challenge and the race */
  strip: ReactNode;
  /** in the View menu */
  sound: ReactNode;
  /** the cards over the maze */
  cards: (view: StageViewStore) => ReactNode;
}

/**
 * Fills its grid area. The stage holds the trail, so that it stays mounted while the page's layout
 * changes.
 */
export function Stage({ hasTools = true, history, strip, sound, cards }: StageProps) {
  const services = useServices();
  const { t, i18n } = useTranslation();
  const [controller] = useState(() => new StageController(services, i18n));
  const layout = useStore(controller.view, (view) => view.layout);
  const isDriving = useStore(services.camera, (camera) => camera.isDriving);
  const scroller = useRef<HTMLDivElement>(null);
  const grid = useRef<HTMLTableElement>(null);
  const layers = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (scroller.current === null || grid.current === null || layers.current === null) {
      return undefined;
    }
    return controller.mount({
      scroller: scroller.current,
      grid: grid.current,
      layers: layers.current,
    });
  }, [controller]);
  useLayoutEffect(() => controller.layoutApplied(), [controller, layout]);
  return (
    <section className={styles["stage"]} aria-label={t("stage.name")} data-driving={isDriving}>
      {isDriving ? (
        <CameraView isWanted view={controller.view} />
      ) : (
        hasTools && (
          <ToolStrip history={history} sound={sound}>
            {strip}
          </ToolStrip>
        )
      )}
      <div
        ref={scroller}
        className={layout?.overflows === true ? styles["scroller"] : styles["still"]}
      >
        <div className={styles["content"]} style={layout?.content} data-ready={layout !== null}>
          <div ref={layers} className={styles["layers"]} style={layout?.view} aria-hidden="true" />
          <MazeGrid controller={controller} element={grid} />
          {cards(controller.view)}
        </div>
      </div>
      {layout?.overflows === true && (
        <SmallMap isWanted view={controller.view} onScroll={controller.scrollTo} />
      )}
      <StageLegend view={controller.view} />
    </section>
  );
}
