/** Draws the pictures of the students' cards: maze, path and robot. */
import type { LessonDocument } from "@corridor/challenge";
import { CELL, sizeOf, type MazeDocument } from "@corridor/maze";
import type { Tile } from "@corridor/protocol";
import { DirtyRects } from "../../stage/drawing/dirty-rects.ts";
import type { Palette } from "../../stage/drawing/palette.ts";
import { drawRobot, type Face } from "../../stage/layers/robot.ts";
import { blocksPath, edgesPath } from "../../ui/maze-outline.ts";
import { tileMaze } from "../protocol/tile-maze.ts";
import { TileMotion, type ShownTile } from "./tile-motion.ts";

/** The robot is larger than in the maze, so that its face can be seen. */
const ROBOT_SIZE = 1.5;
/** Pictures of mazes without a robot that are stored besides those in use. */
const MAX_FLOORS = 32;
/** One for each student of the largest class. */
const MAX_MAZES = 200;

interface Place {
  student: number;
  canvas: OffscreenCanvas;
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
  readonly #dirty = new Set<string>();
  readonly #floors = new Map<string, Floor>();
  /** by task and name, because an unseen maze is generated; null: there is no such maze */
  readonly #mazes = new Map<string, MazeDocument | null>();
  readonly #verified = new Map<number, ReadonlySet<number>>();
  readonly #motions = new Map<number, TileMotion>();
  #lesson: LessonDocument | null = null;
  #palette: Palette | null = null;
  #isCalm = false;
  #isWaiting = false;
  readonly #erased = new DirtyRects();

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

  place(place: string, student: number, canvas: OffscreenCanvas): void {
    this.#places.set(place, { student, canvas, floor: null });
    this.#drawSoon(place);
  }

  resize(place: string, width: number, height: number): void {
    const canvas = this.#places.get(place)?.canvas;
    if (canvas === undefined) return;
    canvas.width = width;
    canvas.height = height;
    this.#drawSoon(place);
  }

  remove(place: string): void {
    this.#places.delete(place);
    this.#dirty.delete(place);
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
    const all = new Set(students);
    for (const [place, { student }] of this.#places) if (all.has(student)) this.#drawSoon(place);
  }

  #removeFloors(): void {
    this.#floors.clear();
    for (const place of this.#places.values()) place.floor = null;
  }

  #drawAll(): void {
    for (const place of this.#places.keys()) this.#drawSoon(place);
  }

  #drawSoon(place: string): void {
    this.#dirty.add(place);
    if (this.#isWaiting) return;
    this.#isWaiting = true;
    this.#ports.requestFrame(() => {
      this.#isWaiting = false;
      const places = [...this.#dirty];
      this.#dirty.clear();
      const now = this.#ports.now();
      for (const each of places) this.#draw(each, now);
    });
  }

  /** While the robot moves, each frame requests the next one. */
  #draw(name: string, now: number): void {
    const found = this.#places.get(name);
    const palette = this.#palette;
    const context = found?.canvas.getContext("2d") ?? null;
    if (found === undefined || palette === null || context === null) return;
    const { student, canvas } = found;
    context.clearRect(0, 0, canvas.width, canvas.height);
    const motion = this.#motions.get(student);
    const shown = (this.#isCalm ? motion?.newest() : motion?.shown(now)) ?? null;
    if (motion?.isMoving === true) this.#drawSoon(name);
    const task = shown?.tile.task ?? 1;
    // Before the first tile, the first maze of the lesson.
    const mazeName = shown === null ? "g1" : shown.tile.maze;
    const maze = this.#mazeOf(task, mazeName);
    if (maze === null) return;
    context.drawImage(this.#floorOf(found, `${task} ${mazeName}`, maze, palette), 0, 0);
    if (shown === null) return;
    const view = viewOf(maze, canvas);
    const isSolved = this.isVerified(student, shown.tile.task);
    drawPath(context, view, shown, isSolved ? palette.good : palette.live);
    this.#drawRobot(context, view, shown, palette, isSolved);
  }

  #drawRobot(
    context: OffscreenCanvasRenderingContext2D,
    { cell, x, y, columns, rows }: CardView,
    { pose, tile: { state } }: ShownTile,
    palette: Palette,
    isSolved: boolean,
  ): void {
    const scale = (cell / CELL) * ROBOT_SIZE;
    const box = { x: 0, y: 0, width: 0, height: 0 };
    const centre = { x: x + (pose.x / CELL) * cell, y: y + (pose.y / CELL) * cell };
    const viewport = {
      scale,
      originX: centre.x - pose.x * scale,
      originY: centre.y - pose.y * scale,
      port: box,
      view: box,
      columns,
      rows,
    };
    const face: Face = isSolved ? "solved" : state === "bumped" ? "bumped" : "driving";
    drawRobot(context, viewport, palette, pose, face, this.#erased);
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
  #floorOf(place: Place, mazeKey: string, maze: MazeDocument, palette: Palette): OffscreenCanvas {
    const { width, height } = place.canvas;
    const key = `${width} ${height} ${mazeKey}`;
    if (place.floor?.key !== key) {
      place.floor = this.#floors.get(key) ?? newFloor(key, maze, place.canvas, palette);
      if (this.#floors.size >= MAX_FLOORS) this.#floors.clear();
      this.#floors.set(key, place.floor);
    }
    return place.floor.picture;
  }
}

function newFloor(
  key: string,
  maze: MazeDocument,
  { width, height }: OffscreenCanvas,
  palette: Palette,
): Floor {
  const picture = new OffscreenCanvas(width, height);
  const context = picture.getContext("2d");
  if (context !== null) drawFloor(context, viewOf(maze, picture), maze, palette);
  return { key, picture };
}

/** Position of the maze in a picture, in device pixels. */
interface CardView {
  cell: number;
  x: number;
  y: number;
  columns: number;
  rows: number;
}

function viewOf(maze: MazeDocument, { width, height }: OffscreenCanvas): CardView {
  const { columns, rows } = sizeOf(maze);
  const cell = Math.min((width - 2) / columns, (height - 2) / rows);
  return { cell, x: (width - cell * columns) / 2, y: (height - cell * rows) / 2, columns, rows };
}

function drawFloor(
  context: OffscreenCanvasRenderingContext2D,
  { cell, x, y, columns, rows }: CardView,
  maze: MazeDocument,
  palette: Palette,
): void {
  const mark = 0.26;
  context.translate(x, y);
  context.scale(cell, cell);
  context.lineWidth = 1.25 / cell;
  context.fillStyle = palette.floor;
  context.fillRect(0, 0, columns, rows);
  context.fillStyle = palette.wall;
  context.fill(new Path2D(blocksPath(maze)));
  context.strokeStyle = palette.wallEdge;
  context.stroke(new Path2D(edgesPath(maze)));
  context.strokeRect(0, 0, columns, rows);
  context.fillStyle = palette.good;
  for (const { column, row } of maze.goals) {
    context.fillRect(column + 0.5 - mark, row + 0.5 - mark, 2 * mark, 2 * mark);
  }
  context.beginPath();
  context.arc(maze.start.column + 0.5, maze.start.row + 0.5, mark, 0, 2 * Math.PI);
  context.fillStyle = palette.surface;
  context.fill();
  context.stroke();
}

function drawPath(
  context: OffscreenCanvasRenderingContext2D,
  { cell, x, y, columns, rows }: CardView,
  { trail }: ShownTile,
  colour: string,
): void {
  context.save();
  context.beginPath();
  context.rect(x, y, columns * cell, rows * cell);
  context.clip();
  context.beginPath();
  for (const point of trail) {
    context.lineTo(x + (point.x / CELL) * cell, y + (point.y / CELL) * cell);
  }
  context.strokeStyle = colour;
  context.lineWidth = Math.max(1.5, cell * 0.14);
  context.lineJoin = "round";
  context.lineCap = "round";
  context.stroke();
  context.restore();
}
