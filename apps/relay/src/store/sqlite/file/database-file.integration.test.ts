import {
  chmodSync,
  existsSync,
  mkdirSync,
  openSync,
  readdirSync,
  readFileSync,
  statSync,
  writeFileSync,
  writeSync,
} from "node:fs";
import { join } from "node:path";
import { describe, expect, it, onTestFinished, vi } from "vitest";
import { addStep, deliverStep, endStep } from "../../../commands/state-machine.ts";
import { completed } from "../../../platform/testing/messages.ts";
import { testFolder } from "../../../testing/test-relay.ts";
import { LONG } from "../live-robots.ts";
import { SqliteDocumentStore } from "../sqlite-document-store.ts";
import { SqliteFile } from "./sqlite-file.ts";

import { SqliteRobotStore } from "../sqlite-robot-store.ts";
import { ROBOTS, withRobots } from "../../cases/robot-in-store.ts";
import { sentCommand } from "../../cases/sent-command.ts";

const document = { ids: ["BBBB"], hash: "h", text: "{}", keyHash: "k", now: 1 };

/** Opens the database as the relay does. */
function opened(path: string) {
  const setAside = vi.fn<(to: string) => void>();
  const file = new SqliteFile(path, { setAside });
  const documents = new SqliteDocumentStore(file);
  onTestFinished(() => file.close());
  return { file, documents, setAside };
}

/** Executes 20 commands on a robot. */
async function driven(store: SqliteRobotStore): Promise<void> {
  await withRobots(store);
  const [robot = ""] = ROBOTS;
  const pose = { x: 50, y: 50, heading: 90 };
  for (let seq = 1; seq <= 20; seq++) {
    await store.commit(robot, addStep(sentCommand()));
    await store.commit(robot, deliverStep(1, 8, 5_000));
    await store.commit(robot, endStep(1, { ...completed(seq), pose }));
  }
}

describe("the database file", () => {
  it("is not readable by other users of the machine, nor are the files beside it", async () => {
    const path = join(testFolder(), "corridor.sqlite");
    writeFileSync(path, "");
    chmodSync(path, 0o644);
    const { documents } = opened(path);
    await documents.add(document);
    const files = readdirSync(join(path, ".."));
    expect(files).toContain("corridor.sqlite-wal");
    for (const name of files) {
      expect([name, statSync(join(path, "..", name)).mode & 0o077]).toEqual([name, 0]);
    }
  });

  it.each([
    {
      name: "is no database",
      damage: (path: string) => writeFileSync(path, "x".repeat(20_000)),
    },
    {
      name: "has a damaged page",
      damage: (path: string) => {
        const file = openSync(path, "r+");
        // The header and the list of tables stay intact.
        writeSync(file, Buffer.alloc(4_096, 0xff), 0, 4_096, 3 * 4_096);
      },
    },
  ])("is moved aside completely if it $name, and replaced by a new one", async ({ damage }) => {
    const path = join(testFolder(), "corridor.sqlite");
    const before = opened(path);
    await before.documents.add(document);
    await before.file.close();
    damage(path);
    const damaged = readFileSync(path);
    const { file, documents, setAside } = opened(path);
    expect(setAside).toHaveBeenCalledExactlyOnceWith(`${path}.damaged`);
    expect(readFileSync(`${path}.damaged`).equals(damaged)).toBe(true);
    expect(await documents.read("BBBB", 1, 1)).toBeNull();
    await documents.add(document);
    expect(await documents.read("BBBB", 1, 1)).toBe("{}");
    await file.close();
    writeFileSync(path, "x".repeat(20_000));
    expect(opened(path).setAside).toHaveBeenCalledWith(`${path}.damaged-2`);
  });

  it.each([
    { what: "a command in the journal", begin: "[20,", journal: LONG },
    { what: "a command in its table", begin: "[1,", journal: 2 },
    { what: "the action of a command", begin: '{\\"action', journal: LONG },
    { what: "the pose at an ending", begin: '{\\"x', journal: LONG },
    { what: "a maze behind a short link", begin: '{"format', journal: LONG },
  ])("is moved aside if the text of $what is corrupt", async ({ begin, journal }) => {
    const path = join(testFolder(), "corridor.sqlite");
    const before = new SqliteFile(path);
    const text = '{"format":"corridor/maze"}';
    await new SqliteDocumentStore(before).add({ ...document, text });
    await driven(new SqliteRobotStore(before, journal));
    await before.close();
    const bytes = readFileSync(path);
    const at = bytes.lastIndexOf(begin);
    bytes.writeUInt8(bytes.readUInt8(at) ^ 0x11, at);
    writeFileSync(path, bytes);
    expect(opened(path).setAside).toHaveBeenCalledExactlyOnceWith(`${path}.damaged`);
  });

  it("stays in place if it is intact", async () => {
    const path = join(testFolder(), "corridor.sqlite");
    const before = opened(path);
    await before.documents.add(document);
    await before.file.close();
    const { documents, setAside } = opened(path);
    expect(setAside).not.toHaveBeenCalled();
    expect(await documents.read("BBBB", 1, 1)).toBe("{}");
  });

  it("is named with its path and a remedy if it cannot be opened", () => {
    const folder = testFolder();
    writeFileSync(join(folder, "file"), "");
    mkdirSync(join(folder, "folder"));
    const paths = [
      join(folder, "file", "corridor.sqlite"),
      join(folder, "folder"),
      // The system rejects a folder here with ENOENT.
      ...(existsSync("/proc/self") ? ["/proc/corridor/corridor.sqlite"] : []),
    ];
    for (const path of paths) {
      expect(() => new SqliteFile(path)).toThrow(
        expect.objectContaining({
          name: "DatabaseFileError",
          message: expect.stringMatching(/permission.*set DATA_DIR to another folder/) as string,
        }),
      );
      expect(() => new SqliteFile(path)).toThrow(path);
    }
  });
});
