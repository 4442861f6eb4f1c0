import type { Snapshot } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { expect, it } from "vitest";
import { CarriedSnapshot } from "./carried-snapshot.ts";
import { FakeClock } from "../platform/testing/fake-clock.ts";
import { readPost, SnapshotPost } from "./snapshot-post.ts";

const [ONE, TWO] = ["AAAAAAAAAAAAAAAAAAAAAA", "BBBBBBBBBBBBBBBBBBBBBB"];

/** Returns the single post that contains these snapshots. */
function posted(snapshots: [robot: string, snapshot: Snapshot][]): Buffer {
  const clock = new FakeClock();
  const posts: Buffer[] = [];
  const post = new SnapshotPost(clock, (_, text) => posts.push(text));
  for (const [robot, value] of snapshots) post.post(robot, CarriedSnapshot.of(value), ["other"]);
  post.flush();
  expect(posts).toHaveLength(1);
  return Buffer.concat(posts);
}

/** Decodes a post to plain objects. */
function read(post: Buffer | string): Record<string, Snapshot> | null {
  const found = readPost(Buffer.from(post));
  return found && Object.fromEntries([...found].map(([robot, { value }]) => [robot, value]));
}

it("delivers the latest snapshot of each robot unchanged", () => {
  const newest = snapshotOf({ seq: 2, line: "default", command: 7 });
  const other = snapshotOf({ seq: 3 });
  const post = posted([
    [ONE, snapshotOf({ seq: 1 })],
    [TWO, other],
    [ONE, newest],
  ]);
  expect(read(post)).toEqual({ [ONE]: newest, [TWO]: other });
});

it("delivers a snapshot with non-ASCII characters", () => {
  const snapshot = snapshotOf({ motion: "höher" });
  expect(read(posted([[ONE, snapshot]]))).toEqual({ [ONE]: snapshot });
});

it.each([
  { name: "spaces", of: (text: string) => text.replaceAll(":", ": ") },
  { name: "fields in another order", of: (text: string) => reordered(text) },
])("reads posts of another version with $name", ({ of }) => {
  const text = JSON.stringify({ [ONE]: snapshotOf(), [TWO]: snapshotOf({ seq: 9 }) });
  expect(of(text)).not.toBe(text);
  expect(read(of(text))).toEqual(JSON.parse(text));
});

it.each(["", "null", "[]", "{", '{"A":', '{"A":1}', '{"A":{}}', `{"${ONE}":{"seq":1}}`, "\u0000"])(
  "rejects invalid input: %j",
  (text) => expect(read(text)).toBeNull(),
);

it("rejects a post that is nearly JSON", () => {
  const text = posted([
    [ONE, snapshotOf()],
    [TWO, snapshotOf()],
  ]).toString();
  expect(read(text.replace('{"A', "{xA"))).toBeNull();
  expect(read(text.replace(',"B', ',,"B'))).toBeNull();
});

it("rejects a truncated post", () => {
  const post = posted([
    [ONE, snapshotOf()],
    [TWO, snapshotOf()],
  ]);
  for (const length of [3, 40, 200, post.length - 1]) {
    expect(read(post.subarray(0, length))).toBeNull();
  }
});

function reordered(text: string): string {
  const robots = Object.entries(JSON.parse(text) as Record<string, Snapshot>);
  return JSON.stringify(
    Object.fromEntries(robots.map(([id, { seq, ...rest }]) => [id, { ...rest, seq }])),
  );
}
