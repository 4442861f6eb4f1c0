/**
 * A card beside the robot, with a tail that points at it. A `good` card stands away from the robot,
 * so that the whole trail stays visible.
 * While it is open, the card keeps its place and follows the layout and size of the stage. On
 * phones, and wherever it would cover the robot or the end of its trail, or would be cut off, it
 * moves into the sheet or the panel.
 */
import { CELL } from "@corridor/maze";
import { X } from "lucide";
import { useId, useLayoutEffect, useRef, useState, type ReactNode } from "react";
import { createPortal } from "react-dom";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { Pose } from "@corridor/protocol";
import { useServices } from "../../model/use-services.ts";
import { viewX, viewY, viewportAt, type Box, type Viewport } from "../../stage/drawing/viewport.ts";
import { Icon } from "../../ui/Icon.tsx";
import { IconButton } from "../../ui/Button.tsx";
import { classNames } from "../../ui/class-names.ts";
import { ROBOT_HALF } from "../../ui/robot-outline.ts";
import { useMediaQuery } from "../../ui/use-media-query.ts";
import type { StageViewStore } from "../../stage/page/stage-view.ts";
import { overlap, placeCard, placeCardAway, type CardPlace } from "./card-place.ts";
import styles from "./cards.module.css";
import { trailEnd, type TrailSide } from "./trail-end.ts";

/** Stages too narrow or too low for a card beside the robot: phones in portrait and landscape. */
const SMALL = "(max-width: 37.49em), (max-height: 33.75em)";
/** Half of the tail's side, in px. */
const TAIL_PX = 8;
/** Hides the card until it is measured and placed. */
const HIDDEN = { visibility: "hidden", left: 0, top: 0 } as const;

interface FloatingCardProps {
  view: StageViewStore;
  /** the robot at the event that the card describes, in units */
  pose: Pose;
  /** cells that the card should not cover: goals, the block that was hit */
  keepClear: readonly { column: number; row: number }[];
  /** directions in which the end of the trail may leave the robot; both if it is unknown */
  trailSides: readonly TrailSide[];
  tone: "bad" | "good";
  icon: ReactNode;
  title: string;
  /** the open task, in a card that covers it in the sheet or the panel */
  task?: ReactNode;
  onClose: () => void;
  children: ReactNode;
}

export function FloatingCard(props: FloatingCardProps) {
  const { view, pose, keepClear, trailSides, tone, icon, title, task, onClose, children } = props;
  const { t } = useTranslation();
  const layout = useStore(view, (state) => state.layout);
  const { cardDock } = useServices();
  const dock = useStore(cardDock, ({ element }) => element);
  const isSmall = useMediaQuery(SMALL);
  const card = useRef<HTMLElement>(null);
  const [place, setPlace] = useState<CardPlace | null>(null);
  /** the layout in which every place would cover the robot or its trail's end, or cut the card off */
  const [tooFull, setTooFull] = useState<typeof layout>(null);
  const isDocked = dock !== null && (isSmall || (layout !== null && tooFull === layout));
  const [half, setHalf] = useState<"upper" | "lower">("upper");
  const hasTask = isDocked && task !== undefined;
  const titleId = useId();

  // Messages stand in the other half (messages.module.css). The attribute is on the root: a
  // selector that looks for the card would match the whole page again on each change.
  useLayoutEffect(() => {
    if (isDocked) return undefined;
    const { dataset } = document.documentElement;
    dataset["cardIn"] = half;
    return () => {
      delete dataset["cardIn"];
    };
  }, [half, isDocked]);

  useLayoutEffect(() => {
    if (tone !== "bad") return undefined;
    cardDock.setState({ hasBump: true });
    return () => cardDock.setState({ hasBump: false });
  }, [cardDock, tone]);

  useLayoutEffect(() => {
    if (!isDocked) return undefined;
    const room = dock.parentElement?.clientHeight ?? 0;
    cardDock.setState({ need: dock.offsetHeight > room ? "more" : "half", hasTask });
    showFromTop(dock);
    return () => cardDock.setState({ need: null, hasTask: false });
  }, [cardDock, isDocked, dock, hasTask]);

  useLayoutEffect(() => {
    const element = card.current;
    if (element === null || layout === null || isDocked) return undefined;
    const put = () => {
      // The card is placed in the content of the stage, so that it scrolls with the robot.
      const viewport = viewportAt(layout, { x: 0, y: 0 });
      const scroller = element.offsetParent?.parentElement;
      const area = {
        x: scroller?.scrollLeft ?? 0,
        y: scroller?.scrollTop ?? 0,
        ...layout.view,
      };
      const squares = keepClear.map(({ column, row }) =>
        boxOf(viewport, column * CELL + CELL / 2, row * CELL + CELL / 2, CELL / 2),
      );
      const robot = boxOf(viewport, pose.x, pose.y, ROBOT_HALF);
      const trailEnds = trailSides.map((side) => boxAt(viewport, trailEnd(pose, side)));
      const seen = [...trailEnds, ...squares];
      const { port } = layout;
      const legend = heightBelow(scroller);
      const inMaze = { ...port, x: area.x + port.x, y: area.y + port.y };
      // The legend is the last resort, and only on a stage that does not scroll.
      const stage = layout.overflows ? area : { ...area, height: area.height + legend };
      const shaped = (shape: "tall" | "wide") => {
        element.dataset["shape"] = shape;
        return { shape, width: element.offsetWidth, height: element.offsetHeight };
      };
      // A wider card is lower, and may fit where the tall one does not.
      const shapes = [shaped("tall"), shaped("wide")];
      const next =
        tone === "bad"
          ? placeCard([area, stage], robot, shapes, seen)
          : placeCardAway([inMaze, area, stage], robot, shapes, seen);
      if (next === null) return;
      const covered = { ...next.shape, x: next.x, y: next.y };
      const coversTrail = trailEnds.some((end) => overlap(covered, end) > 0);
      if (next.coversRobot || next.isCut || coversTrail) {
        setTooFull(layout);
        return;
      }
      element.dataset["shape"] = next.shape.shape;
      const above = next.y - area.y;
      const below = area.height - above - next.shape.height + legend;
      setHalf(above > below ? "lower" : "upper");
      setPlace(next);
    };
    put();
    const resize = new ResizeObserver(put);
    resize.observe(element);
    return () => resize.disconnect();
  }, [layout, isDocked, pose, keepClear, trailSides, tone]);

  const at = isDocked ? null : place;
  const section = (
    <section
      ref={card}
      aria-labelledby={titleId}
      data-card=""
      className={classNames(styles["card"], styles[tone], isDocked && styles["docked"])}
      style={isDocked ? undefined : at === null ? HIDDEN : { left: at.x, top: at.y }}
    >
      {at !== null && <Tail place={at} />}
      {hasTask && task}
      <header className={styles["header"]}>
        <span className={styles["icon"]}>{icon}</span>
        <h2 id={titleId} className={styles["title"]}>
          {title}
        </h2>
        <IconButton label={t("shell.close")} onClick={onClose}>
          <Icon of={X} />
        </IconButton>
      </header>
      {children}
    </section>
  );
  return isDocked ? createPortal(section, dock) : section;
}

/**
 * Height of the legend below the drawing area, in px; 0 on a narrow stage, which has none. Messages
 * may cover it too.
 */
function heightBelow(scroller: Element | null | undefined): number {
  const stage = scroller?.parentElement;
  if (!scroller || !stage) return 0;
  return stage.getBoundingClientRect().bottom - scroller.getBoundingClientRect().bottom;
}

/** Scrolls the containers of the dock in the panel to their top, but not the page. */
function showFromTop(dock: HTMLElement): void {
  const panel = dock.closest("aside");
  let each = dock.parentElement;
  while (each !== null && panel?.contains(each) === true) {
    each.scrollTop = 0;
    each = each.parentElement;
  }
}

/** Uses physical left and top in every language, because the maze is never mirrored. */
function Tail({ place: { tail, tailAt } }: { place: CardPlace }) {
  if (tail === null) return null;
  const isBeside = tail === "left" || tail === "right";
  return (
    <span
      className={styles["tail"]}
      data-side={tail}
      style={{ [tail]: -TAIL_PX, [isBeside ? "top" : "left"]: tailAt - TAIL_PX }}
    />
  );
}

function boxOf(viewport: Viewport, x: number, y: number, half: number): Box {
  return boxAt(viewport, { x: x - half, y: y - half, width: 2 * half, height: 2 * half });
}

/** @param box in units */
function boxAt(viewport: Viewport, { x, y, width, height }: Box): Box {
  return {
    x: viewX(viewport, x),
    y: viewY(viewport, y),
    width: width * viewport.scale,
    height: height * viewport.scale,
  };
}
