/**
 * The maze with the robot, drawn by the worker. The drawing is hidden from screen readers, which
 * read a sentence instead.
 */
import { useEffect, useLayoutEffect, useRef, useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { cellOf, facingOf } from "../../stage/page/robot-place.ts";
import { applyScroll } from "../../stage/page/stage-scroll.ts";
import { createStageView } from "../../stage/page/stage-view.ts";
import type { WatchClient } from "./watch-client.ts";
import { openWatchStage } from "./watch-stage.ts";
import { robotState, type WatchState, type WatchStore } from "./watch-store.ts";
import styles from "./watch.module.css";

export function WatchStage({ store, client }: { store: WatchStore; client: WatchClient }) {
  const { t, i18n } = useTranslation(["words", "watch"], { useSuspense: false });
  const scroller = useRef<HTMLDivElement>(null);
  const layers = useRef<HTMLDivElement>(null);
  const [view] = useState(createStageView);
  const layout = useStore(view, (state) => state.layout);
  const isUnknown = useStore(store, ({ maze, snapshot }) => maze === null && snapshot !== null);
  const isHere = useStore(store, (state) => ["running", "paused"].includes(robotState(state)));
  const label = useStore(store, (state) => describe(state, t));
  useEffect(() => {
    if (scroller.current === null || layers.current === null) return undefined;
    return openWatchStage({
      client,
      store,
      words: i18n,
      scroller: scroller.current,
      layers: layers.current,
      view,
    });
  }, [client, store, i18n, view]);
  useLayoutEffect(() => {
    if (scroller.current !== null) applyScroll(view, scroller.current);
  }, [view, layout]);
  return (
    <main className={styles["stage"]}>
      <p className="visually-hidden">{label}</p>
      <div
        ref={scroller}
        className={layout?.overflows === true ? styles["scroller"] : styles["still"]}
        data-here={isHere}
      >
        <div className={styles["content"]} style={layout?.content}>
          <div ref={layers} className={styles["layers"]} style={layout?.view} aria-hidden="true" />
        </div>
      </div>
      {isUnknown && <p className={styles["unknown"]}>{t("watch:mazeUnknown")}</p>}
    </main>
  );
}

/** A sentence that changes with the square and the direction of the robot, not with each step. */
function describe(
  { maze, snapshot }: WatchState,
  t: ReturnType<typeof useTranslation<["words", "watch"]>>["t"],
): string {
  if (maze === null || maze === undefined || snapshot === null) return t("watch:robot");
  const { column, row } = cellOf(snapshot.pose);
  return t("watch:robotIn", {
    maze: maze.name,
    place: t("stage.cell.at", { row: row + 1, column: column + 1 }),
    facing: t(`stage.facing.${facingOf(snapshot.pose.heading)}`),
  });
}
