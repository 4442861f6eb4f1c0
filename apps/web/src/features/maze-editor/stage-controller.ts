/**
 * The part of the stage outside React: connects the stores, the pointer and the renderer.
 * Components pass their elements to `mount` and read the view store.
 */
import { MAX_GOALS, MAX_SIDE, sizeOf, type Cell, type MazeDocument } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";
import type { i18n } from "i18next";
import type { Services } from "../../model/services.ts";
import type { CameraState } from "../../model/screen/camera-store.ts";
import type { EditPreview } from "../../stage/layers/edit-preview.ts";
import { Camera } from "../../stage/camera.ts";
import { PointerInput } from "../../stage/page/pointer-input.ts";
import type { Measured } from "../../stage/layers/measure.ts";
import { readPalette, type Palette } from "../../stage/drawing/palette.ts";
import {
  shownProperties,
  observePixelRatio,
  observeTheme,
} from "../../stage/page/observe-theme.ts";
import type { Scroll } from "../../stage/drawing/viewport.ts";
import { showMessage } from "../../model/screen/screen-store.ts";
import { MazeEditor } from "./maze-editor.ts";
import { MeasureTool } from "./measure-tool.ts";
import { gridOffset } from "../../stage/page/grid-place.ts";
import { divideStage, hasRulers, type StageRoom } from "../../stage/page/stage-layout.ts";
import {
  applyScroll,
  followRequest,
  moveScroll,
  readScroll,
  setLayout,
} from "../../stage/page/stage-scroll.ts";
import { stageLinkOf } from "../../simulator/stage-link.ts";
import { openStageScreen } from "../../stage/page/open-stage-screen.ts";
import type { StageScreen } from "../../stage/page/stage-screen.ts";
import { tapeWords, type Tape } from "../../stage/page/tape.ts";
import { createStageView } from "../../stage/page/stage-view.ts";
import { listenToPointer } from "./stage-pointer.ts";
import { startLater } from "./start-later.ts";
import { showUndoable } from "../../model/workspace/show-undoable.ts";
import { previewOf, type ToolRefusal } from "./tool-edit.ts";

/** The elements of the stage. */
export interface StageElements {
  /** scrolls if the maze is larger than the view */
  scroller: HTMLElement;
  /** lies over the maze and receives the pointer */
  grid: HTMLElement;
  /** contains the canvases */
  layers: HTMLElement;
}

export class StageController {
  readonly view = createStageView();
  readonly editor: MazeEditor;
  readonly measure: MeasureTool;
  readonly #services: Services;
  readonly #words: Pick<i18n, "t" | "language">;
  readonly #pointer: PointerInput;
  readonly #camera = new Camera();
  #drawing: StageScreen | null = null;
  #elements: StageElements | null = null;
  #palette: Palette | null = null;
  #pixelRatio = 1;
  #isCalm = false;
  /** the maze's size and whether a camera follows the robot: the zoom applies to these only */
  #zoomedFor = "";
  #drawnTape: { tape: Tape; measured: Measured } | null = null;

  constructor(services: Services, words: Pick<i18n, "t" | "language">) {
    this.#services = services;
    this.#words = words;
    this.editor = new MazeEditor({
      workspace: services.workspace,
      screen: services.screen,
      pose: () => this.#pose(),
      isFixed: () => this.#isMazeFixed(),
      refuse: (code) => this.#showRefusal(code),
      goalsRemoved: (count) =>
        showUndoable(services, words, words.t("stage.goalsRemoved", { count })),
    });
    this.measure = new MeasureTool(this.view);
    this.#pointer = new PointerInput((intent) => {
      if (intent.type === "hover") this.view.setState({ hover: intent.cell });
      if (intent.type === "begin") this.view.setState({ cursor: intent.cell });
      this.editor.follow(intent);
    });
  }

  /** Starts drawing and adds the listeners. @returns a function that stops both */
  mount(elements: StageElements): () => void {
    const { workspace, screen, run, simulator, camera } = this.#services;
    const { scroller, grid } = elements;
    const drawing = openStageScreen(stageLinkOf(simulator), elements.layers, (scroll) =>
      followRequest(this.view, scroller, scroll),
    );
    this.#elements = elements;
    this.#drawing = drawing;
    const recolour = (): void => {
      this.#palette = readPalette(shownProperties());
      this.#show();
    };
    recolour();
    const measure = new ResizeObserver(() => this.#divide());
    measure.observe(scroller);
    const listeners = new AbortController();
    const { signal } = listeners;
    const onScroll = (): void => readScroll(this.view, scroller);
    scroller.addEventListener("scroll", onScroll, { passive: true, signal });
    grid.addEventListener("focusin", () => this.#seeFocus(grid), { signal });
    const onKey = (event: KeyboardEvent): void => {
      if (event.key !== "Escape") return;
      this.#pointer.cancel();
      // A dialog or popover has the key to itself. Removing a tape handles the key.
      const isCovered = document.querySelector("dialog:modal, :popover-open") !== null;
      if (!isCovered && this.measure.clear()) event.preventDefault();
    };
    window.addEventListener("keydown", onKey, { capture: true, signal });
    const calm = matchMedia("(prefers-reduced-motion: reduce)");
    const onCalm = (): void => {
      this.#isCalm = calm.matches;
      this.#panGrid();
      this.#show();
    };
    onCalm();
    calm.addEventListener("change", onCalm, { signal });
    const stops = [
      listenToPointer({
        services: this.#services,
        view: this.view,
        scroller,
        grid,
        input: this.#pointer,
        measure: this.measure,
      }),
      observeTheme(recolour),
      observePixelRatio((pixelRatio) => {
        this.#pixelRatio = pixelRatio;
        this.#show();
      }),
      workspace.subscribe(() => this.#divide()),
      screen.subscribe(({ tool }, before) => {
        if (tool !== before.tool) this.#toolChanged();
        this.#divide();
      }),
      camera.subscribe(() => {
        this.#pointer.cancel();
        this.#pointer.leave();
        this.#divide();
      }),
      run.subscribe(({ pastMaze: shownMaze, snapshot }, before) => {
        if (shownMaze !== before.pastMaze) this.#divide();
        if (snapshot?.pose !== before.snapshot?.pose) this.#panGrid();
      }),
      this.view.subscribe(({ layout }, before) => {
        if (layout !== null && layout !== before.layout) {
          this.#pointer.setTouchScroll(layout.overflows);
          this.#panGrid();
        }
        this.#show();
      }),
      this.#listenToZoom(scroller),
      this.#publishRobotSide(),
      () => measure.disconnect(),
      () => listeners.abort(),
      () => drawing.end(),
    ];
    this.#divide();
    this.#show();
    return () => {
      for (const stop of stops) stop();
      this.#drawing = null;
      this.#elements = null;
    };
  }

  /** Scrolls to another part of the maze. */
  readonly scrollTo = (scroll: Scroll): void => {
    if (this.#elements !== null) moveScroll(this.view, this.#elements.scroller, scroll);
  };

  /** Called when the elements have the sizes of the newest layout. */
  layoutApplied(): void {
    if (this.#elements !== null) applyScroll(this.view, this.#elements.scroller);
  }

  /**
   * Loads the gestures when the pointer or a finger is first on the stage, so that the first screen
   * does not load them.
   * @returns a function that removes the listeners
   */
  #listenToZoom(scroller: HTMLElement): () => void {
    const { camera } = this.#services;
    const failed = (): void => {
      showMessage(this.#services.screen, {
        tone: "bad",
        text: this.#words.t("offline.partFailed"),
      });
    };
    const zoom: CameraState["zoom"] = (by, at) => {
      void import("../../stage/page/stage-zoom.ts").then(({ zoomStage }) => {
        const room = this.#room();
        if (room === null) return;
        this.#pointer.cancel();
        if (by === "fit" && camera.getState().isDriving) camera.setState({ isWhole: true });
        else zoomStage(this.view, room, by, at, this.#pose());
      }, failed);
    };
    camera.setState({ zoom });
    const load = (): void => {
      stop = startLater(async () => {
        const { listenToZoom } = await import("./zoom-gestures.ts");
        return listenToZoom(scroller, zoom);
      }, failed);
    };
    scroller.addEventListener("pointerenter", load, { once: true });
    let stop = (): void => scroller.removeEventListener("pointerenter", load);
    return () => {
      stop();
      camera.setState({ zoom: () => {} });
    };
  }

  /** Publishes the robot's side once there are messages. @returns a function that stops it */
  #publishRobotSide(): () => void {
    const { screen, run } = this.#services;
    let stop = screen.subscribe(({ messages }) => {
      if (messages.length === 0) return;
      stop();
      // Without it messages stay on one side. Another message would replace the first one.
      stop = startLater(async () => {
        const { publishRobotSide } = await import("./robot-side.ts");
        return publishRobotSide(this.view, run);
      });
    });
    return () => stop();
  }

  /**
   * The keyboard can move to a square that the camera does not show; then the whole maze is
   * displayed.
   */
  #seeFocus(grid: HTMLElement): void {
    if (grid.querySelector(":focus-visible") === null) return;
    // A press focuses a square too; moving the camera would cancel its stroke.
    const { camera } = this.#services;
    const { isDriving, isWhole } = camera.getState();
    if (isDriving && !isWhole) camera.setState({ isWhole: true });
  }

  #toolChanged(): void {
    this.#pointer.cancel();
    this.#pointer.leave();
    this.measure.clear();
  }

  /**
   * Computes the layout again after the size of the stage or the maze, or the rulers, have changed.
   */
  #divide(): void {
    const room = this.#room();
    if (room === null) return;
    if (!setLayout(this.view, divideStage(room))) this.#show();
  }

  /** What the layout depends on; null while the stage has no size. */
  #room(): StageRoom | null {
    if (this.#elements === null) return null;
    const { scroller } = this.#elements;
    const view = { width: scroller.clientWidth, height: scroller.clientHeight };
    if (view.width === 0 || view.height === 0) return null;
    const { showRulers } = this.#services.screen.getState();
    const { isDriving, isWhole } = this.#services.camera.getState();
    const maze = sizeOf(this.#shownMaze());
    const follows = isDriving && !isWhole;
    // A maze of another size, and another camera mode, start with their own zoom.
    const zoomedFor = `${maze.columns} ${maze.rows} ${follows}`;
    if (zoomedFor !== this.#zoomedFor) {
      this.#zoomedFor = zoomedFor;
      if (this.view.getState().zoom !== null) this.view.setState({ zoom: null });
    }
    return { maze, view, showRulers, follows, zoom: this.view.getState().zoom };
  }

  /** The maze of the displayed tick, which can differ from the current one. */
  #shownMaze(): MazeDocument {
    const { run, workspace } = this.#services;
    return run.getState().pastMaze ?? workspace.getState().maze;
  }

  /** Moves the squares for screen readers to where the camera shows them. */
  #panGrid(): void {
    const { layout } = this.view.getState();
    const pose = this.#pose();
    if (layout === null || this.#elements === null) return;
    const { x, y } = gridOffset(this.#camera, layout, pose, this.#isCalm, this.#pixelRatio);
    this.#elements.grid.style.translate = `${x}px ${y}px`;
  }

  #show(): void {
    const { layout, scroll, answers, hover, tape } = this.view.getState();
    if (layout === null || this.#palette === null) return;
    const { program } = this.#services.workspace.getState();
    const { showBeams, showTrail, showRulers } = this.#services.screen.getState();
    this.#drawing?.show({
      layout,
      scroll,
      answers,
      pixelRatio: this.#pixelRatio,
      palette: this.#palette,
      maze: this.#shownMaze(),
      program,
      startWord: this.#words.t("stage.startWord"),
      goalWord: this.#words.t("stage.goalWord"),
      showBeams,
      showTrail,
      showRulers: hasRulers(layout.view.width, showRulers),
      preview: hover === null ? null : this.#previewAt(hover),
      measured: this.#measured(tape),
      isCalm: this.#isCalm,
    });
  }

  /** Returns the same object for the same tape, because models are compared field by field. */
  #measured(tape: Tape | null): Measured | null {
    if (tape === null) return null;
    if (tape !== this.#drawnTape?.tape) {
      const { from, to } = tape;
      // Isolates each line: a canvas does not detect the direction of text.
      const lines = tapeWords(this.#words.t, this.#words.language, tape);
      const words = lines.map((line) => `\u2068${line}\u2069`);
      this.#drawnTape = { tape, measured: { from, to, words } };
    }
    return this.#drawnTape.measured;
  }

  /** Whether an open challenge fixes its maze. */
  #isMazeFixed(): boolean {
    return this.#services.challenge.getState().rights?.maze === false;
  }

  #previewAt(cell: Cell): EditPreview | null {
    const { tool } = this.#services.screen.getState();
    if (tool === "measure") return null;
    if (this.#isMazeFixed()) return { kind: "refused", cell };
    const { maze } = this.#services.workspace.getState();
    return previewOf(maze, tool, cell, this.#pose());
  }

  /** The robot's pose in the newest snapshot; null before the first frame. */
  #pose(): Pose | null {
    return this.#services.run.getState().snapshot?.pose ?? null;
  }

  #showRefusal(code: ToolRefusal): void {
    const most = code === "too-many-goals" ? MAX_GOALS : MAX_SIDE;
    showMessage(this.#services.screen, {
      tone: "info",
      text: this.#words.t(`stage.refused.${code}`, { most }),
    });
  }
}
