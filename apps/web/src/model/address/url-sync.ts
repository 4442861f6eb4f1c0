/**
 * Requests in the page's address: a shared link, long or short, a recorded run or a lesson opens
 * as a new project beside the user's own. A robot's address opens another page: `features/watch`.
 */
import type { LessonDocument } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";
import type { FieldProblem } from "@corridor/protocol";
import type { ProgramDocument } from "@corridor/program";
import type { RunDocument } from "@corridor/recording";
import type { i18n } from "i18next";
import { dismiss, showMessage, type ScreenStore } from "../screen/screen-store.ts";
import { missionOfHash } from "./mission-address.ts";
import { replayStart, withoutReplayStart } from "./replay-start.ts";
import type { decodeSharedLink, SharedContent } from "./shared-link.ts";
import type { ShortLinkResult } from "./short-link.ts";
import type { ProjectService } from "../projects/project-service.ts";

export interface UrlPorts {
  projects: Pick<ProjectService, "beginShared" | "list">;
  /** loads the link parser, which only an address with a link needs; may fail like any file */
  loadLinks: () => Promise<{ decodeSharedLink: typeof decodeSharedLink }>;
  /** loads the document of a short link; may fail like any file */
  readShortLink: (id: string) => Promise<ShortLinkResult>;
  /** the displayed maze, for links with only a program */
  maze: () => MazeDocument;
  /** the program for links with only a maze: empty, or null if the user has written one */
  programForMaze: () => ProgramDocument | null;
  screen: ScreenStore;
  words: Pick<i18n, "t">;
  location: Pick<Location, "pathname" | "search" | "hash">;
  /** replaces the address without a reload: history.replaceState */
  replaceAddress: (address: string) => void;
  openEmptyMaze: () => void;
  /** opens a recorded run, see `openRun`; resolves with its problems */
  openRun: (run: RunDocument, from: number | null) => Promise<readonly FieldProblem[]>;
  /**
   * opens a lesson with the program of the link, if any. Resolves with whether it opened; otherwise
   * a message has been shown
   */
  openLesson: (lesson: LessonDocument, program: ProgramDocument | null) => Promise<boolean>;
  /** opens the mission of this id; resolves with whether it exists; may fail like any file */
  openMission: (id: string) => Promise<boolean>;
  /** replaces an address without a mission by that of the open one, with a message */
  refuseMission: () => void;
}

/**
 * Performs the request of the address once, and removes it, so that a reload retains the user's
 * edits. Called when the page opens and whenever the fragment changes.
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
    // The address retains the link, so that a reload opens it, too.
    return showNotLoaded(ports);
  }
  const result = links.decodeSharedLink(hash.slice(1));
  if (result.ok && result.value.run !== undefined) {
    await openRecorded(ports, result.value.run, replayStart(search));
    // A long run takes time, and a reload meanwhile starts again; another link may have been opened
    // since.
    if (location.hash === hash) replaceAddress(pathname + withoutReplayStart(search));
    return;
  }
  if (result.ok && result.value.lesson !== undefined) {
    const { lesson, program = null } = result.value;
    await openShownLesson(ports, lesson, program, () => {
      if (location.hash === hash) replaceAddress(pathname + search);
    });
    return;
  }
  replaceAddress(pathname + search);
  if (result.ok) openShared(ports, result.value);
  else showBadLink(ports, words.t(`share.linkProblems.${result.code}`));
}

/** The address stays: it is that of the mission. */
async function followMission(ports: UrlPorts, id: string): Promise<void> {
  let isThere: boolean;
  try {
    isThere = await ports.openMission(id);
  } catch {
    return showNotLoaded(ports);
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
    return showNotLoaded(ports);
  }
  if (!result.ok && result.sentence === "share.shortLink.wait") {
    return showNotOpened(ports, words.t(result.sentence));
  }
  const clean = () => {
    if (location.pathname === pathname) replaceAddress(`/${search}`);
  };
  if (result.ok && result.value.lesson !== undefined) {
    return openShownLesson(ports, result.value.lesson, null, clean);
  }
  clean();
  if (result.ok) openShared(ports, result.value);
  else showBadLink(ports, words.t(result.sentence));
}

/** @param clean removes the link from the address */
async function openShownLesson(
  ports: UrlPorts,
  lesson: LessonDocument,
  program: ProgramDocument | null,
  clean: () => void,
): Promise<void> {
  const isOwner = hasOwnProject(ports);
  // A lesson that did not load stays in the address: a reload tries again.
  if (!(await ports.openLesson(lesson, program))) return;
  clean();
  const key =
    lesson.tasks.length > 1
      ? (`missions:lesson.${isOwner ? "openedBeside" : "opened"}` as const)
      : (`share.openedChallenge${isOwner ? "Beside" : ""}` as const);
  showMessage(ports.screen, { tone: "info", text: ports.words.t(key) });
}

function showBadLink(ports: UrlPorts, text: string): void {
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

function showNotLoaded(ports: UrlPorts): void {
  showNotOpened(ports, ports.words.t("offline.linkFailed"));
}

/** The address retains the link, so that it can be retried. */
function showNotOpened(ports: UrlPorts, text: string): void {
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

async function openRecorded(
  { openRun, screen, words }: UrlPorts,
  run: RunDocument,
  from: number | null,
): Promise<void> {
  const [problem] = await openRun(run, from);
  if (problem === undefined) return;
  showMessage(screen, { tone: "bad", text: words.t("timeline.notOpened", { ...problem }) });
}

function openShared(ports: UrlPorts, content: SharedContent): void {
  const { screen, words } = ports;
  const isOwner = hasOwnProject(ports);
  const back = ports.projects.beginShared(
    content.maze ?? ports.maze(),
    // A maze alone is a task: only a program that the user has written is copied.
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

/** Whether the user has edited anything here, stored or refused by the storage. */
function hasOwnProject({ projects, screen }: UrlPorts): boolean {
  return projects.list().some(({ edited }) => edited) || screen.getState().saved === "blocked";
}
