/** Follows the browser's own address: `url-sync.ts` on the real page. Comes only where the address asks for something. */
import type { i18n } from "i18next";
import { openEmptyMaze } from "../features/works/empty-maze.ts";
import type { Services } from "./services.ts";
import { followAddress } from "./url-sync.ts";

export async function followPageAddress(services: Services, words: i18n): Promise<void> {
  await followAddress({
    ...services,
    words,
    loadLinks: () => import("@corridor/link"),
    readShortLink: async (id) => {
      const { readShortLink } = await import("./short-link.ts");
      return readShortLink(id, (url) => fetch(url));
    },
    maze: () => services.workspace.getState().maze,
    location,
    replaceAddress: (address) => history.replaceState(history.state, "", address),
    openEmptyMaze: () => openEmptyMaze(services, words),
    openRun: async (run) => {
      const { openRun } = await import("../features/timeline/open-run.ts");
      return openRun(services, words, run);
    },
    openChallenge: (challenge, program) => services.lessons.openShared(challenge, program),
  });
}
