/** The part of a viewer's stage outside React: the stage model and the layout. */
import { sizeOf } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { i18n } from "i18next";
import { readPalette, type Palette } from "../../stage/drawing/palette.ts";
import { openStageScreen } from "../../stage/page/open-stage-screen.ts";
import { hasRulers, stageLayout } from "../../stage/page/stage-layout.ts";
import { followRequest, readScroll, setLayout } from "../../stage/page/stage-scroll.ts";
import type { StageViewStore } from "../../stage/page/stage-view.ts";
import {
  shownProperties,
  observePixelRatio,
  observeTheme,
} from "../../stage/page/observe-theme.ts";
import type { WatchClient } from "./watch-client.ts";
import type { WatchStore } from "./watch-store.ts";

/** Viewers do not receive the lines of the robot's program. */
const noProgram: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "",
  default: "forward",
  rules: [],
};

export interface WatchStagePorts {
  client: WatchClient;
  store: WatchStore;
  words: Pick<i18n, "t">;
  /** scrolls if the maze is larger than the view */
  scroller: HTMLElement;
  /** receives the canvases */
  layers: HTMLElement;
  view: StageViewStore;
}

/** Starts drawing. @returns a function that ends it */
export function openWatchStage(ports: WatchStagePorts): () => void {
  const { client, store, words, scroller, layers, view } = ports;
  const screen = openStageScreen(client, layers, (scroll) => followRequest(view, scroller, scroll));
  const calm = matchMedia("(prefers-reduced-motion: reduce)");
  let palette: Palette = readPalette(shownProperties());
  let pixelRatio = window.devicePixelRatio;

  function show(): void {
    const { maze } = store.getState();
    const room = { width: scroller.clientWidth, height: scroller.clientHeight };
    if (maze === null || maze === undefined || room.width === 0 || room.height === 0) return;
    setLayout(view, stageLayout(sizeOf(maze), room, true));
    const { layout, scroll, answers } = view.getState();
    if (layout === null) return;
    screen.show({
      layout,
      scroll,
      answers,
      pixelRatio,
      palette,
      maze,
      program: noProgram,
      startWord: words.t("stage.startWord"),
      goalWord: words.t("stage.goalWord"),
      showBeams: true,
      showTrail: true,
      showRulers: hasRulers(room.width, true),
      preview: null,
      measured: null,
      isCalm: calm.matches,
    });
  }

  const recolour = (): void => {
    palette = readPalette(shownProperties());
    show();
  };
  const onScroll = (): void => readScroll(view, scroller);
  const measure = new ResizeObserver(show);
  measure.observe(scroller);
  scroller.addEventListener("scroll", onScroll, { passive: true });
  calm.addEventListener("change", show);
  const stops = [
    observeTheme(recolour),
    observePixelRatio((next) => {
      pixelRatio = next;
      show();
    }),
    store.subscribe(({ maze }, before) => {
      if (maze !== before.maze) show();
    }),
    view.subscribe(({ scroll }, before) => {
      if (scroll !== before.scroll) show();
    }),
    () => measure.disconnect(),
    () => scroller.removeEventListener("scroll", onScroll),
    () => calm.removeEventListener("change", show),
    () => screen.end(),
  ];
  show();
  return () => {
    for (const stop of stops) stop();
  };
}
