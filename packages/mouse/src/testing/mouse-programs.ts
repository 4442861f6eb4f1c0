/** Two micromouse programs, which know the simulator only by lines of text. */

/** What a program is connected to. */
export interface ProgramLines {
  /** Sends a command, and reads its response. */
  ask: (line: string) => Promise<string>;
  /** Sends a command without a response. */
  say: (line: string) => void;
}

const sides = ["n", "e", "s", "w"] as const;
const steps = [
  [0, 1],
  [1, 0],
  [0, -1],
  [-1, 0],
] as const;

/** Follows the wall on the left to the centre. @returns whether it is there */
export async function followWall({ ask, say }: ProgramLines): Promise<boolean> {
  const width = Number(await ask("mazeWidth"));
  const height = Number(await ask("mazeHeight"));
  let [x, y, heading] = [0, 0, 0];
  for (let step = 0; step < 4 * width * height; step += 1) {
    say(`setColor ${x} ${y} g`);
    if (isCentre(x, width) && isCentre(y, height)) return true;
    if ((await ask("wallLeft")) === "false") {
      await ask("turnLeft");
      heading = (heading + 3) % 4;
    }
    while ((await ask("wallFront")) === "true") {
      await ask("turnRight");
      heading = (heading + 1) % 4;
    }
    if ((await ask("moveForward")) !== "ack") return false;
    x += steps[heading]?.[0] ?? 0;
    y += steps[heading]?.[1] ?? 0;
  }
  return false;
}

/** Drives to the centre by flood fill, back, and there again by the shortest known path. */
export async function floodFill({ ask, say }: ProgramLines): Promise<boolean> {
  const width = Number(await ask("mazeWidth"));
  const height = Number(await ask("mazeHeight"));
  const walls = new Set<string>();
  let [x, y, heading] = [0, 0, 0];

  const distancesTo = (isGoal: (x: number, y: number) => boolean): number[] => {
    const distances = Array.from({ length: width * height }, () => Number.POSITIVE_INFINITY);
    const queue: [number, number][] = [];
    for (let row = 0; row < height; row += 1) {
      for (let column = 0; column < width; column += 1) {
        if (!isGoal(column, row)) continue;
        distances[row * width + column] = 0;
        queue.push([column, row]);
      }
    }
    for (const [column, row] of queue) {
      for (const [side, [dx, dy]] of steps.entries()) {
        const [nextColumn, nextRow] = [column + dx, row + dy];
        const isInside = nextColumn >= 0 && nextColumn < width && nextRow >= 0 && nextRow < height;
        if (!isInside || walls.has(`${column} ${row} ${sides[side]}`)) continue;
        if (distances[nextRow * width + nextColumn] !== Number.POSITIVE_INFINITY) continue;
        distances[nextRow * width + nextColumn] = (distances[row * width + column] ?? 0) + 1;
        queue.push([nextColumn, nextRow]);
      }
    }
    return distances;
  };

  const note = (side: number): void => {
    const [dx, dy] = steps[side] ?? [0, 0];
    walls.add(`${x} ${y} ${sides[side]}`);
    walls.add(`${x + dx} ${y + dy} ${sides[(side + 2) % 4]}`);
    say(`setWall ${x} ${y} ${sides[side]}`);
  };

  const driveTo = async (isGoal: (x: number, y: number) => boolean): Promise<boolean> => {
    for (;;) {
      if ((await ask("wallFront")) === "true") note(heading);
      if ((await ask("wallRight")) === "true") note((heading + 1) % 4);
      if ((await ask("wallLeft")) === "true") note((heading + 3) % 4);
      const distances = distancesTo(isGoal);
      for (const [at, distance] of distances.entries()) {
        say(`setText ${at % width} ${Math.floor(at / width)} ${distance}`);
      }
      const here = distances[y * width + x] ?? Number.POSITIVE_INFINITY;
      if (here === 0) return true;
      const next = [heading, (heading + 1) % 4, (heading + 3) % 4, (heading + 2) % 4].find(
        (side) => {
          const [dx, dy] = steps[side] ?? [0, 0];
          if (walls.has(`${x} ${y} ${sides[side]}`)) return false;
          return distances[(y + dy) * width + x + dx] === here - 1;
        },
      );
      if (next === undefined) return false;
      const turn = (next - heading + 4) % 4;
      if (turn === 3) await ask("turnLeft");
      for (let quarter = 0; quarter < turn && turn < 3; quarter += 1) await ask("turnRight");
      heading = next;
      if ((await ask("moveForward")) !== "ack") return false;
      x += steps[heading]?.[0] ?? 0;
      y += steps[heading]?.[1] ?? 0;
    }
  };

  const isGoal = (column: number, row: number): boolean =>
    isCentre(column, width) && isCentre(row, height);
  const isStart = (column: number, row: number): boolean => column === 0 && row === 0;
  const isDone = (await driveTo(isGoal)) && (await driveTo(isStart)) && (await driveTo(isGoal));
  for (const stat of ["total-distance", "best-run-turns", "score"]) await ask(`getStat ${stat}`);
  return isDone;
}

function isCentre(at: number, size: number): boolean {
  return at === Math.floor(size / 2) || at === Math.floor((size - 1) / 2);
}
