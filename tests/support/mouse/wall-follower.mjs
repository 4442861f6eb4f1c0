// A micromouse program for mms: follows the wall on the right to the centre.
import { createInterface } from "node:readline";

const input = createInterface({ input: process.stdin })[Symbol.asyncIterator]();
const say = (line) => process.stdout.write(`${line}\n`);
const ask = async (line) => {
  say(line);
  return (await input.next()).value;
};

const steps = [
  [0, 1],
  [1, 0],
  [0, -1],
  [-1, 0],
];
const width = Number(await ask("mazeWidth"));
const height = Number(await ask("mazeHeight"));
const isMiddle = (at, size) => at === Math.floor(size / 2) || at === Math.floor((size - 1) / 2);
let [x, y, heading] = [0, 0, 0];

while (!(isMiddle(x, width) && isMiddle(y, height))) {
  say(`setColor ${x} ${y} G`);
  if ((await ask("wallRight")) === "false") {
    await ask("turnRight");
    heading = (heading + 1) % 4;
  }
  while ((await ask("wallFront")) === "true") {
    await ask("turnLeft");
    heading = (heading + 3) % 4;
  }
  if ((await ask("moveForward")) !== "ack") throw new Error("crash");
  x += steps[heading][0];
  y += steps[heading][1];
}
say(`setText ${x} ${y} centre`);
process.stderr.write(`turns ${await ask("getStat total-turns")}\n`);
process.exit();
