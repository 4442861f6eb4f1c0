/** Measures by how much the dashboard's memory grows during the tiles of a long lesson. */
import type { StudentTile, Tile } from "@corridor/protocol";
import type { Browser } from "playwright";
import { measurePageMemory, type PageMemory } from "../page-memory.ts";
import { DrivenRobot } from "./driven-robot.ts";
import { openDashboard, startClass, startStudents } from "./live-class.ts";
import { PacedTiles } from "./paced-tiles.ts";

/** Interval of batches of the relay. */
const BATCH_MS = 500;
/** Batches before the first measurement, so that caches are filled. */
const WARM_UP = 240;
/** Length of the run from which all tiles come; each student is at another part of it. */
const RUN_TILES = 1_200;
const APART_TILES = 29;
const SETTLE_MS = 2_000;

export interface MemoryJob {
  browser: Browser;
  /** address of the relay */
  relay: string;
  students: number;
  /** of the lesson */
  seconds: number;
}

/** @returns the memory before and after, and how much faster than the lesson the tiles arrived */
export async function measureTileMemory(
  job: MemoryJob,
): Promise<{ before: PageMemory; after: PageMemory; speed: number }> {
  const { browser, relay, students, seconds } = job;
  const run = drivenTiles();
  const batch = (n: number): StudentTile[] =>
    Array.from({ length: students }, (_, at) => {
      const tile = run[(n + at * APART_TILES) % run.length];
      return {
        student: at + 1,
        connected: true,
        tile: tile === undefined ? null : { ...tile, seq: n + 1 },
      };
    });
  const tiles = await PacedTiles.start(relay);
  const teacher = await startClass(relay);
  const stop = await startStudents({ relay, code: teacher.code, students });
  try {
    const page = await openDashboard(browser, tiles.url, teacher, students);
    await tiles.send(WARM_UP, batch);
    await page.waitForTimeout(SETTLE_MS);
    const before = await measurePageMemory(page);
    const startedAt = performance.now();
    await tiles.send((seconds * 1_000) / BATCH_MS, batch);
    const elapsed = performance.now() - startedAt;
    await page.waitForTimeout(SETTLE_MS);
    const after = await measurePageMemory(page);
    await page.close();
    return { before, after, speed: (seconds * 1_000) / elapsed };
  } finally {
    await stop();
    await tiles.close();
  }
}

function drivenTiles(): Tile[] {
  const robot = new DrivenRobot(0);
  const tiles: Tile[] = [];
  while (tiles.length < RUN_TILES) {
    const tile = robot.drive(BATCH_MS);
    if (tile !== null) tiles.push(tile);
  }
  return tiles;
}
