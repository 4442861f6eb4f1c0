/**
 * The messages of pages and scripts, the same for all peers: messages of the product of usual size.
 */
const TAIL =
  ',"state":"running","driver":"program","sensors":{"front":250.5,"right":49.62,"back":349.5,"left":50.38},"pose":{"x":149.62,"y":1150.25,"heading":90},"motion":"forward","bumps":0,"bumping":false,"goalReached":false,"line":0,"command":null}}';

/**
 * A snapshot of a page. Its tick rises, because the relay treats a robot with constant ticks as
 * asleep.
 */
export function snapshotText(n: number, epoch: number): string {
  return `{"type":"snapshot","epoch":${epoch},"snapshot":{"seq":${n},"tick":${n * 2}${TAIL}`;
}

/** Reads `seq` from a message in any field order. @returns NaN if there is none */
export function parseSeq(text: string): number {
  const at = text.indexOf('"seq":');
  let n = 0;
  for (let i = at + 6; i < text.length; i++) {
    const digit = text.charCodeAt(i) - 48;
    if (digit < 0 || digit > 9) break;
    n = n * 10 + digit;
  }
  return at < 0 ? Number.NaN : n;
}

/** A command of a script. Its unique key makes it a new command, not a retry. */
export function commandText(n: number): string {
  return `{"type":"command","key":"bench-${String(n).padStart(9, "0")}","command":{"action":"move","distance":120,"ttl":10000}}`;
}

/** A velocity of a script. Each differs from the one before. */
export function driveText(n: number): string {
  const power = 0.1 + (n % 50) / 100;
  return `{"type":"command","key":"bench-${String(n).padStart(9, "0")}","command":{"action":"drive","left":${power},"right":${power}}}`;
}

/** The same velocity of a ROS client, as the libraries send it. */
export function twistText(n: number): string {
  const speed = 0.3 + (n % 50) / 100;
  return `{"op":"publish","id":"publish:/cmd_vel:${n}","topic":"/cmd_vel","msg":{"linear":{"x":${speed},"y":0,"z":0},"angular":{"x":0,"y":0,"z":0}},"latch":false}`;
}

/** The number of the snapshot that a message of `/odom` shows: its stamp is the tick. */
export function parseStamp(text: string): number {
  const [, sec, nanosec] = /"sec":(\d+),"nanosec":(\d+)/.exec(text) ?? [];
  return Math.round(Number(sec) * 60 + (Number(nanosec) * 60) / 1e9) / 2;
}

/** An answer of a page, for peers without their own answers; as long as the product's record. */
export function answerText(n: number): string {
  return `{"type":"ack","record":{"seq":${n},"key":"bench-000000001","action":"move","command":{"action":"move","distance":120},"state":"accepted","reason":null,"acceptedAt":"2026-01-01T00:00:00.000Z","pose":null,"distance":null,"duplicate":false}}`;
}
