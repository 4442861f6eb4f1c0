/** Draws the pictures of the students when they change. All cards in view share a canvas. */
import type { LessonDocument } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";
import type { Tile } from "@corridor/protocol";
import type { Palette } from "../../stage/drawing/palette.ts";
import type { PictureBox } from "../protocol/classroom-messages.ts";
import { tileMaze } from "../protocol/tile-maze.ts";
import { drawFloor, drawRun, fade, viewOf } from "./draw-picture.ts";
import { TileMotion } from "./tile-motion.ts";

/** Pictures of mazes without a robot that are stored besides those in use. */
const MAX_FLOORS = 32;
/** One for each student of the largest class. */
const MAX_MAZES = 200;

/** A canvas of the page. */
interface Place {
  canvas: OffscreenCanvas;
  width: number;
  height: number;
  /** by student */
  pictures: Map<number, Picture>;
  /** boxes of pictures that are not there any more */
  erased: PictureBox[];
}

interface Picture {
  place: Place;
  box: PictureBox;
  /** null: none was drawn yet */
  floor: Floor | null;
}

/** The picture of a maze without a robot. */
interface Floor {
  key: string;
  picture: OffscreenCanvas;
}

export interface CardPainterPorts {
  tileOf(student: number): Tile | null;
  requestFrame(paint: () => void): void;
  /** monotonic ms */
  now(): number;
}

export class CardPainter {
  readonly #ports: CardPainterPorts;
  readonly #places = new Map<string, Place>();
  readonly #dirty = new Set<Picture>();
  readonly #floors = new Map<string, Floor>();
  /** by task and name, because an unseen maze is generated; null: there is no such maze */
  readonly #mazes = new Map<string, MazeDocument | null>();
  readonly #verified = new Map<number, ReadonlySet<number>>();
  readonly #motions = new Map<number, TileMotion>();
  #lesson: LessonDocument | null = null;
  #palette: Palette | null = null;
  #isCalm = false;
  #isWaiting = false;

  constructor(ports: CardPainterPorts) {
    this.#ports = ports;
  }

  setLesson(lesson: LessonDocument): void {
    this.#lesson = lesson;
    this.#mazes.clear();
    this.#removeFloors();
    this.#drawAll();
  }

  setPalette(palette: Palette): void {
    this.#palette = palette;
    this.#removeFloors();
    this.#drawAll();
  }

  /** @param isCalm robots jump from tile to tile, as the settings of the device ask for */
  setCalm(isCalm: boolean): void {
    this.#isCalm = isCalm;
    this.#drawAll();
  }

  setVerified(student: number, tasks: readonly number[]): void {
    this.#verified.set(student, new Set(tasks));
    this.#drawStudents([student]);
  }

  isVerified(student: number, task: number): boolean {
    return this.#verified.get(student)?.has(task) === true;
  }

  place(place: string, canvas: OffscreenCanvas): void {
    const { width, height } = canvas;
    this.#places.set(place, { canvas, width, height, pictures: new Map(), erased: [] });
  }

  /** Replaces the pictures of a canvas. @param width of the canvas, in device pixels */
  arrange(name: string, width: number, height: number, boxes: readonly PictureBox[]): void {
    const place = this.#places.get(name);
    if (place === undefined) return;
    const isResized = place.width !== width || place.height !== height;
    const before = place.pictures;
    place.pictures = new Map();
    place.width = width;
    place.height = height;
    for (const box of boxes) {
      const known = before.get(box.student);
      const isSame = !isResized && known !== undefined && isSameBox(known.box, box);
      const picture = isSame ? known : { place, box, floor: known?.floor ?? null };
      place.pictures.set(box.student, picture);
      if (isSame) before.delete(box.student);
      else this.#drawSoon(picture);
    }
    for (const picture of before.values()) {
      place.erased.push(picture.box);
      this.#dirty.delete(picture);
    }
    this.#paintSoon();
  }

  remove(name: string): void {
    for (const picture of this.#places.get(name)?.pictures.values() ?? []) {
      this.#dirty.delete(picture);
    }
    this.#places.delete(name);
  }

  /** These students have new tiles. */
  changed(students: readonly number[]): void {
    const now = this.#ports.now();
    for (const student of students) {
      const tile = this.#ports.tileOf(student);
      if (tile === null) continue;
      const motion = this.#motions.get(student) ?? new TileMotion();
      this.#motions.set(student, motion);
      motion.add(tile, now);
    }
    this.#drawStudents(students);
  }

  #drawStudents(students: readonly number[]): void {
    for (const { pictures } of this.#places.values()) {
      for (const student of students) {
        const picture = pictures.get(student);
        if (picture !== undefined) this.#drawSoon(picture);
      }
    }
  }

  *#pictures(): Generator<Picture> {
    for (const { pictures } of this.#places.values()) yield* pictures.values();
  }

  #removeFloors(): void {
    this.#floors.clear();
    for (const picture of this.#pictures()) picture.floor = null;
  }

  #drawAll(): void {
    for (const picture of this.#pictures()) this.#drawSoon(picture);
  }

  #drawSoon(picture: Picture): void {
    this.#dirty.add(picture);
    this.#paintSoon();
  }

  #paintSoon(): void {
    if (this.#isWaiting) return;
    this.#isWaiting = true;
    this.#ports.requestFrame(() => {
      this.#isWaiting = false;
      for (const place of this.#places.values()) erase(place);
      const pictures = [...this.#dirty];
      this.#dirty.clear();
      const now = this.#ports.now();
      for (const each of pictures) this.#draw(each, now);
    });
  }

  /** While the robot moves, each frame requests the next one. */
  #draw(picture: Picture, now: number): void {
    const { place, box } = picture;
    const palette = this.#palette;
    const context = place.canvas.getContext("2d");
    if (palette === null || context === null) return;
    context.clearRect(box.x, box.y, box.width, box.height);
    const motion = this.#motions.get(box.student);
    const shown = (this.#isCalm ? motion?.newest() : motion?.shown(now)) ?? null;
    if (motion?.isMoving === true) this.#drawSoon(picture);
    const task = shown?.tile.task ?? 1;
    // Before the first tile, the first maze of the lesson.
    const mazeName = shown === null ? "g1" : shown.tile.maze;
    const maze = this.#mazeOf(task, mazeName);
    if (maze === null) return;
    const view = viewOf(maze, box);
    context.drawImage(this.#floorOf(picture, `${task} ${mazeName}`, maze, palette), box.x, box.y);
    if (shown !== null) {
      const isSolved = this.isVerified(box.student, shown.tile.task);
      drawRun(context, box, view, shown, palette, isSolved);
    }
    if (box.isOld) fade(context, box, view);
  }

  #mazeOf(task: number, name: string | null): MazeDocument | null {
    if (this.#lesson === null || name === null) return null;
    const key = `${task} ${name}`;
    let maze = this.#mazes.get(key);
    if (maze === undefined) {
      maze = tileMaze(this.#lesson, task, name);
      if (this.#mazes.size >= MAX_MAZES) this.#mazes.clear();
      this.#mazes.set(key, maze);
    }
    return maze;
  }

  /** @param mazeKey names the maze in this lesson */
  #floorOf(
    picture: Picture,
    mazeKey: string,
    maze: MazeDocument,
    palette: Palette,
  ): OffscreenCanvas {
    const { width, height } = picture.box;
    const key = `${width} ${height} ${mazeKey}`;
    if (picture.floor?.key !== key) {
      picture.floor = this.#floors.get(key) ?? {
        key,
        picture: drawFloor(maze, width, height, palette),
      };
      if (this.#floors.size >= MAX_FLOORS) this.#floors.clear();
      this.#floors.set(key, picture.floor);
    }
    return picture.floor.picture;
  }
}

function isSameBox(one: PictureBox, other: PictureBox): boolean {
  const { x, y, width, height, isOld } = one;
  const isPlaced = x === other.x && y === other.y;
  return isPlaced && width === other.width && height === other.height && isOld === other.isOld;
}

/** Erases what is not there any more. A new size erases everything. */
function erase(place: Place): void {
  const { canvas, width, height } = place;
  const boxes = place.erased.splice(0);
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
    return;
  }
  if (boxes.length === 0) return;
  const context = canvas.getContext("2d");
  for (const box of boxes) context?.clearRect(box.x, box.y, box.width, box.height);
}
