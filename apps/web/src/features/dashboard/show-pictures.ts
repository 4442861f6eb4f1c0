/**
 * Shows the pictures of an area's students on one canvas, or, in an area higher than a window, on
 * one canvas for each part of it that is in view. The worker draws the pictures; the page sends
 * their boxes only when the layout or the pictures in view change. The canvases scroll with the
 * page, so scrolling needs no drawing.
 */
import type { Dashboard } from "../../model/classroom/dashboard.ts";
import type { PictureBox } from "../../simulator/protocol/classroom-messages.ts";
import { observePixelRatio } from "../../stage/page/observe-theme.ts";
import styles from "./student-card.module.css";

/** Pictures this close to the view are drawn, so that none appears late. */
const NEAR = "200px";
/** Height of a canvas, in CSS pixels: about that of a window, which limits its memory. */
const PART_PX = 1_280;

interface Part {
  place: string;
  canvas: HTMLCanvasElement;
}

/** @returns a function that removes the canvases */
export function showPictures(area: HTMLElement, dashboard: Dashboard, id: string): () => void {
  /** by number, from the top of the area */
  const parts = new Map<number, Part>();
  const near = new Set<HTMLElement>();
  let frame: number | null = null;

  const update = (): void => {
    const layout = layoutOf(area, near);
    for (const [n, { place, canvas }] of parts) {
      if (layout.parts.has(n)) continue;
      parts.delete(n);
      canvas.remove();
      dashboard.send({ type: "canvas-gone", place });
    }
    for (const [n, pictures] of layout.parts) {
      const part = parts.get(n) ?? addPart(area, dashboard, `${id} ${n}`);
      parts.set(n, part);
      const { width, ratio } = layout;
      const top = n * layout.partHeight;
      const height = Math.min(layout.partHeight, layout.height - top);
      // Exactly its pixels, so that the browser does not scale it.
      part.canvas.style.inlineSize = `${width / ratio}px`;
      part.canvas.style.blockSize = `${height / ratio}px`;
      part.canvas.style.insetBlockStart = `${top / ratio}px`;
      dashboard.send({ type: "pictures", place: part.place, width, height, pictures });
    }
  };

  const visibility = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) {
        if (!target.isConnected) visibility.unobserve(target);
        if (isIntersecting) near.add(target as HTMLElement);
        else near.delete(target as HTMLElement);
      }
      update();
    },
    { rootMargin: NEAR },
  );
  const updateSoon = (): void => {
    frame ??= requestAnimationFrame(() => {
      frame = null;
      for (const picture of picturesIn(area)) visibility.observe(picture);
      update();
    });
  };
  const sizes = new ResizeObserver(update);
  sizes.observe(area);
  // Students come, leave and change places; pictures get old.
  const changes = new MutationObserver(updateSoon);
  changes.observe(area.firstElementChild ?? area, { childList: true });
  changes.observe(area, { subtree: true, attributeFilter: ["data-old"] });
  // Calls at once, too: the first update.
  const stopPixelRatio = observePixelRatio(updateSoon);
  const stopPrints = copyForPrint(area, parts);
  return () => {
    if (frame !== null) cancelAnimationFrame(frame);
    visibility.disconnect();
    sizes.disconnect();
    changes.disconnect();
    stopPixelRatio();
    stopPrints();
    near.clear();
    update();
  };
}

function picturesIn(area: HTMLElement): NodeListOf<HTMLElement> {
  return area.querySelectorAll<HTMLElement>("[data-picture]");
}

function addPart(area: HTMLElement, dashboard: Dashboard, place: string): Part {
  const canvas = document.createElement("canvas");
  canvas.className = styles["canvas"] ?? "";
  area.append(canvas);
  const offscreen = canvas.transferControlToOffscreen();
  dashboard.send({ type: "canvas", place, canvas: offscreen }, [offscreen]);
  return { place, canvas };
}

/** Everything in device pixels. */
interface Layout {
  width: number;
  height: number;
  partHeight: number;
  ratio: number;
  /** boxes in each part that has any, relative to the part */
  parts: Map<number, PictureBox[]>;
}

function layoutOf(area: HTMLElement, pictures: Iterable<HTMLElement>): Layout {
  const ratio = window.devicePixelRatio;
  const partHeight = Math.round(PART_PX * ratio);
  const parts = new Map<number, PictureBox[]>();
  const outer = area.getBoundingClientRect();
  for (const picture of pictures) {
    const box = picture.getBoundingClientRect();
    if (box.width === 0) continue;
    const x = Math.round((box.left - outer.left) * ratio);
    const y = Math.round((box.top - outer.top) * ratio);
    const width = Math.round(box.width * ratio);
    const height = Math.round(box.height * ratio);
    const student = Number(picture.dataset["picture"]);
    const isOld = picture.dataset["old"] !== undefined;
    // A picture on the edge of two parts is drawn on both.
    const last = Math.floor((y + height - 1) / partHeight);
    for (let n = Math.floor(y / partHeight); n <= last; n++) {
      const boxes = parts.get(n) ?? [];
      parts.set(n, boxes);
      boxes.push({ student, x, y: y - n * partHeight, width, height, isOld });
    }
  }
  const [width, height] = [Math.round(outer.width * ratio), Math.round(outer.height * ratio)];
  return { width, height, partHeight, ratio, parts };
}

/**
 * Paper has another layout than the window, and the worker cannot draw meanwhile: each picture in
 * view is copied into its place. @returns a function that stops that
 */
function copyForPrint(area: HTMLElement, parts: ReadonlyMap<number, Part>): () => void {
  const copies: HTMLCanvasElement[] = [];
  const copy = (): void => {
    const layout = layoutOf(area, picturesIn(area));
    for (const [n, boxes] of layout.parts) {
      const part = parts.get(n);
      for (const { student, x, y, width, height } of part === undefined ? [] : boxes) {
        const place = area.querySelector(`[data-picture="${student}"]`);
        const canvas = document.createElement("canvas");
        canvas.width = width;
        canvas.height = height;
        if (part !== undefined) canvas.getContext("2d")?.drawImage(part.canvas, -x, -y);
        place?.append(canvas);
        copies.push(canvas);
      }
    }
  };
  const remove = (): void => {
    for (const canvas of copies.splice(0)) canvas.remove();
  };
  window.addEventListener("beforeprint", copy);
  window.addEventListener("afterprint", remove);
  return () => {
    window.removeEventListener("beforeprint", copy);
    window.removeEventListener("afterprint", remove);
  };
}
