/**
 * What the address bar asks for: a shared link, long or short, a recorded run or a challenge opens as
 * a new work beside the reader's own. A robot's address opens another page: `features/watch`.
 */
import type { ChallengeDocument } from "@corridor/challenge";
import type { decodeLink, LinkContent } from "@corridor/link";
import type { MazeDocument } from "@corridor/maze";
import type { FieldProblem } from "@corridor/protocol";
import type { ProgramDocument } from "@corridor/program";
import type { RunDocument } from "@corridor/recording";
import type { i18n } from "i18next";
import { dismiss, showMessage, type ScreenStore } from "../stores/screen-store.ts";
import { missionOfHash } from "../features/lessons/mission-address.ts";
import type { ShortLinkResult } from "./short-link.ts";
import type { WorksService } from "./works-service.ts";

export interface UrlPorts {
  works: Pick<WorksService, "beginShared" | "list">;
  /** brings what reads links, which only an address with a link needs; may fail as files may */
  loadLinks: () => Promise<{ decodeLink: typeof decodeLink }>;
  /** fetches what a short link leads to; may fail as files may */
  readShortLink: (id: string) => Promise<ShortLinkResult>;
  /** the maze on the screen, for links that bring only a program */
  maze: () => MazeDocument;
  /** the program for links that bring only a maze: empty, or null where the reader has written one */
  programForMaze: () => ProgramDocument | null;
  screen: ScreenStore;
  words: Pick<i18n, "t">;
  location: Pick<Location, "pathname" | "search" | "hash">;
  /** replaces the address without a reload: history.replaceState */
  replaceAddress: (address: string) => void;
  openEmptyMaze: () => void;
  /** opens a recorded run; gives what is wrong with it, or nothing */
  openRun: (run: RunDocument) => Promise<readonly FieldProblem[]>;
  /**
   * opens a challenge; `program` is what the link brought along, if anything. Gives whether it did:
   * where its files do not come, that is told already
   */
  openChallenge: (
    challenge: ChallengeDocument,
    program: ProgramDocument | null,
  ) => Promise<boolean>;
  /** opens the mission of this id; gives whether there is one; may fail as files may */
  openMission: (id: string) => Promise<boolean>;
  /** replaces an address that names no mission by that of what is open, and says so */
  refuseMission: () => void;
}

/**
 * Does what the address asks for, once, and cleans it, so that a reload keeps the reader's edits.
 * Called when the page opens and whenever the fragment changes.
 */
export async function followAddress(ports: UrlPorts): Promise<void> {
  const { location, replaceAddress, words } = ports;
  if (location.pathname.startsWith("/m/")) return followShortLink(ports);
  const { hash } = location;
  if (hash === "" || hash === "#") return;
  const mission = missionOfHash(hash);
  if (mission !== null) return followMission(ports, mission);
  const { pathname, search } = location;
  let links: Awaited<ReturnType<UrlPorts["loadLinks"]>>;
  try {
    links = await ports.loadLinks();
  } catch {
    // The address keeps the link, so that a reload opens it as well.
    return tellNotLoaded(ports);
  }
  const result = links.decodeLink(hash.slice(1));
  if (result.ok && result.value.run !== undefined) {
    await openRecorded(ports, result.value.run);
    // A long run takes its time, and a reload meanwhile begins again; another link may have come since.
    if (location.hash === hash) replaceAddress(pathname + search);
    return;
  }
  if (result.ok && result.value.challenge !== undefined) {
    const { challenge, program = null } = result.value;
    await openShownChallenge(ports, challenge, program, () => {
      if (location.hash === hash) replaceAddress(pathname + search);
    });
    return;
  }
  replaceAddress(pathname + search);
  if (result.ok) openShared(ports, result.value);
  else tellBadLink(ports, words.t(`share.linkProblems.${result.code}`));
}

/** The address stays: it is that of the mission. */
async function followMission(ports: UrlPorts, id: string): Promise<void> {
  let isThere: boolean;
  try {
    isThere = await ports.openMission(id);
  } catch {
    return tellNotLoaded(ports);
  }
  if (!isThere) ports.refuseMission();
}

async function followShortLink(ports: UrlPorts): Promise<void> {
  const { location, replaceAddress, words } = ports;
  const { pathname, search } = location;
  let result: ShortLinkResult;
  try {
    const [, , id = ""] = pathname.split("/");
    result = await ports.readShortLink(id);
  } catch {
    return tellNotLoaded(ports);
  }
  if (!result.ok && result.sentence === "share.shortLink.wait") {
    return tellNotOpened(ports, words.t(result.sentence));
  }
  const clean = () => {
    if (location.pathname === pathname) replaceAddress(`/${search}`);
  };
  if (result.ok && result.value.challenge !== undefined) {
    return openShownChallenge(ports, result.value.challenge, null, clean);
  }
  clean();
  if (result.ok) openShared(ports, result.value);
  else tellBadLink(ports, words.t(result.sentence));
}

/** @param clean takes the link out of the address */
async function openShownChallenge(
  ports: UrlPorts,
  challenge: ChallengeDocument,
  program: ProgramDocument | null,
  clean: () => void,
): Promise<void> {
  const isOwner = hasOwnWork(ports);
  // One that did not come stays in the address: a reload asks for it again.
  if (!(await ports.openChallenge(challenge, program))) return;
  clean();
  const key = isOwner ? "share.openedChallengeBeside" : "share.openedChallenge";
  showMessage(ports.screen, { tone: "info", text: ports.words.t(key) });
}

function tellBadLink(ports: UrlPorts, text: string): void {
  const { screen, words } = ports;
  const id = showMessage(screen, {
    tone: "bad",
    text,
    action: {
      label: words.t("share.emptyMaze"),
      run: () => {
        dismiss(screen, id);
        ports.openEmptyMaze();
      },
    },
  });
}

function tellNotLoaded(ports: UrlPorts): void {
  tellNotOpened(ports, ports.words.t("offline.linkFailed"));
}

/** The address keeps the link, so that it can be tried again. */
function tellNotOpened(ports: UrlPorts, text: string): void {
  const { screen, words } = ports;
  const id = showMessage(screen, {
    tone: "bad",
    text,
    action: {
      label: words.t("offline.tryAgain"),
      run: () => {
        dismiss(screen, id);
        void followAddress(ports);
      },
    },
  });
}

async function openRecorded({ openRun, screen, words }: UrlPorts, run: RunDocument): Promise<void> {
  const [problem] = await openRun(run);
  if (problem === undefined) return;
  showMessage(screen, { tone: "bad", text: words.t("timeline.notOpened", { ...problem }) });
}

function openShared(ports: UrlPorts, content: LinkContent): void {
  const { screen, words } = ports;
  const isOwner = hasOwnWork(ports);
  const back = ports.works.beginShared(
    content.maze ?? ports.maze(),
    // A maze alone is to be solved: only a program that the reader has written comes along.
    content.program ?? ports.programForMaze(),
  );
  if (!isOwner) {
    showMessage(screen, { tone: "info", text: words.t("share.opened") });
    return;
  }
  const id = showMessage(screen, {
    tone: "info",
    text: words.t("share.openedBeside"),
    action: {
      label: words.t("share.back"),
      run: () => {
        dismiss(screen, id);
        back();
      },
    },
  });
}

/** Whether the reader has made anything here: saved by an edit, or edited and refused by the storage. */
function hasOwnWork({ works, screen }: UrlPorts): boolean {
  return works.list().some(({ edited }) => edited) || screen.getState().saved === "blocked";
}
