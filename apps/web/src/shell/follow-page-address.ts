/**
 * Follows the browser's address: `url-sync.ts` on the real page. Loaded only for an address with a
 * request.
 */
import type { i18n } from "i18next";
import { missionHash } from "../model/address/mission-address.ts";
import { programForMaze } from "../model/workspace/own-program.ts";
import { holdAgain } from "../features/share/held-link.ts";
import { openEmptyMaze } from "../features/projects/open-empty-maze.ts";
import { dismiss, showMessage } from "../model/screen/screen-store.ts";
import type { Services } from "../model/services.ts";
import { followAddress } from "../model/address/url-sync.ts";

/**
 * @param isLoad whether the page has just opened; otherwise the user navigated to another fragment
 */
export async function followPageAddress(
  services: Services,
  words: Pick<i18n, "t">,
  isLoad: boolean,
): Promise<void> {
  if (isLoad && holdAgain(services.workspace, window)) return;
  await followAddress({
    ...services,
    words,
    loadLinks: () => import("../model/address/shared-link.ts"),
    readShortLink: async (id) => {
      const { readShortLink } = await import("../model/address/short-link.ts");
      return readShortLink(
        id,
        (url) => fetch(url),
        async () => new Promise((resolve) => setTimeout(resolve, 1_000)),
      );
    },
    maze: () => services.workspace.getState().maze,
    programForMaze: () => programForMaze(services.workspace.getState().program, words),
    location,
    replaceAddress: (address) => history.replaceState(history.state, "", address),
    openEmptyMaze: () => openEmptyMaze(services, words),
    openRun: async (run, from) => {
      const { openRun } = await import("../model/projects/open-run.ts");
      return openRun(services, words, run, from);
    },
    openLesson: (lesson, program) => services.lessons.openShared(lesson, program),
    openMission: async (id) => (await services.lessons.load()).navigation.follow(id),
    refuseMission: () => {
      const { mission } = services.challenge.getState();
      const { pathname, search } = location;
      const hash = mission === null ? "" : missionHash(mission);
      history.replaceState(null, "", pathname + search + hash);
      const message = showMessage(services.screen, {
        tone: "bad",
        text: words.t("missions:path.unknown"),
        action: {
          label: words.t("missions:path.all"),
          run: () => {
            dismiss(services.screen, message);
            services.challenge.setState({ isPathOpen: true });
          },
        },
      });
    },
  });
}
