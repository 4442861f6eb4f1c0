import { rightsOf } from "@corridor/challenge";
import { encodeLink, type LinkContent } from "@corridor/link";
import { describe, expect, it, vi } from "vitest";
import { decodeSharedLink } from "../../model/address/shared-link.ts";
import type { ShortLinkResult } from "../../model/address/short-link.ts";
import { threeTasks } from "../../model/challenge/testing/three-tasks.ts";
import { createChallengeStore } from "../../model/challenge/challenge-store.ts";
import { createWorkspaceStore } from "../../model/workspace/workspace-store.ts";
import { firstMaze, firstProgram } from "../../simulator/protocol/first-project.ts";
import { EmbeddedContent, type View } from "./embedded-content.ts";

function linkOf(content: LinkContent): string {
  const result = encodeLink(content);
  if (!result.ok) throw new Error(`no link: ${result.code}`);
  return result.text;
}

const [task] = threeTasks.tasks;
if (task === undefined) throw new Error("no task");
const rights = rightsOf(task);

function openContent(readShortLink: (id: string) => Promise<ShortLinkResult>) {
  const views: View[] = [];
  const openShared = vi.fn<() => Promise<boolean>>(async () => true);
  const beginShared = vi.fn<() => () => void>(() => () => undefined);
  const content = new EmbeddedContent({
    services: {
      lessons: { openShared, handOver: async () => undefined },
      projects: { beginShared },
      simulator: { send: () => undefined, listen: () => () => undefined, isGone: false },
      workspace: createWorkspaceStore(firstMaze, firstProgram),
      challenge: createChallengeStore(),
    },
    rights,
    decode: async (link) => decodeSharedLink(link),
    readShortLink,
    onOpened: (view) => views.push(view),
  });
  return { content, views, openShared, beginShared };
}

const gone = async (): Promise<ShortLinkResult> => ({
  ok: false,
  sentence: "share.shortLink.gone",
});

describe("a frame", () => {
  it("shows a maze without the author's program, and links to it", async () => {
    const { content, views, beginShared } = openContent(gone);
    const link = linkOf({ maze: firstMaze });
    await content.open({ link });
    expect(views).toEqual([{ kind: "open", address: `/#${link}` }]);
    expect(beginShared).toHaveBeenCalledWith(firstMaze, expect.objectContaining({ rules: [] }));
  });

  it("shows a lesson of a short link", async () => {
    const { content, views, openShared } = openContent(async () => ({
      ok: true,
      value: { lesson: threeTasks },
    }));
    await content.open({ id: "BCDF" });
    expect(views).toEqual([{ kind: "open", address: "/m/BCDF" }]);
    expect(openShared).toHaveBeenCalledWith(threeTasks, null);
  });

  it.each([
    { link: "1%", problem: "broken" },
    { link: linkOf({ maze: firstMaze }).slice(0, -3), problem: "broken" },
    { link: `9${linkOf({ maze: firstMaze }).slice(1)}`, problem: "newer" },
  ])("says that a link does not work: $problem", async ({ link, problem }) => {
    const { content, views } = openContent(gone);
    await content.open({ link });
    expect(views).toEqual([{ kind: "problem", problem }]);
  });

  it("says why a short link does not open, and tries it again", async () => {
    const answers = [
      async () => gone(),
      async () => Promise.reject(new Error("no network")),
      async (): Promise<ShortLinkResult> => ({ ok: true, value: { maze: firstMaze } }),
    ];
    const { content, views } = openContent(async () => (answers.shift() ?? gone)());
    await content.open({ id: "BCDF" });
    await content.open({ id: "BCDF" });
    await content.retry();
    expect(views).toMatchObject([
      { problem: "gone" },
      { problem: "offline" },
      { kind: "open", address: "/m/BCDF" },
    ]);
  });

  it("opens the first and the newest of many requests at once", async () => {
    const asked: string[] = [];
    const read = async (id: string) => {
      asked.push(id);
      return gone();
    };
    const { content, views } = openContent(read);
    const ids = Array.from({ length: 20 }, (_, at) => `BB${"BCDFGHJKLMNPQRSTVWXZ"[at] ?? ""}B`);
    await Promise.all(ids.map(async (id) => content.open({ id })));
    await vi.waitFor(() => expect(views).toHaveLength(2));
    expect(asked).toEqual([ids[0], ids.at(-1)]);
  });
});
