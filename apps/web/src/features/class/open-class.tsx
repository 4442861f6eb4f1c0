/** Connects the page to the class that its tab has joined. Loads only if there is one. */
import type { i18n } from "i18next";
import { storedMembership } from "../../model/classes/membership.ts";
import { ClassWork } from "../../model/classes/class-work.ts";
import { StudentClass } from "../../model/classes/student-class.ts";
import type { Services } from "../../model/services.ts";
import type { KeyValueStorage } from "../../model/storage/key-value-storage.ts";
import { ClassMenu } from "./ClassMenu.tsx";
import { HelpRequest } from "./HelpRequest.tsx";
import { PauseBand } from "./PauseBand.tsx";

/**
 * @param tab sessionStorage
 * @returns a function that opens the lesson of the class and reports the work on it, once the run of
 *   the tab is restored
 */
export async function openClass(
  services: Services,
  words: Pick<i18n, "t" | "loadNamespaces">,
  tab: KeyValueStorage,
): Promise<() => void> {
  const { simulator, classes, screen } = services;
  const joined = storedMembership(tab);
  if (joined === null) return () => undefined;
  await words.loadNamespaces(["join", "names"]);
  const later = (call: () => void, ms: number) => {
    const timer = setTimeout(call, ms);
    return () => clearTimeout(timer);
  };
  const onPause = (endsAt: number | null) => {
    // The relay states the end of the same pause again whenever the page connects.
    const isNew = classes.getState().pause === null;
    classes.setState({ pause: endsAt === null ? null : <PauseBand endsAt={endsAt} /> });
    if (endsAt !== null && isNew) closeEverything();
  };
  let work: ClassWork | null = null;
  const onEnd = () => {
    work?.close();
    classes.setState({ menu: null, help: undefined });
  };
  const studentClass = new StudentClass(
    { simulator, screen, tab, words, now: Date.now, onPause, onEnd, later },
    joined,
  );
  classes.setState({
    menu: <ClassMenu joined={studentClass} work={null} />,
    help: (look) => <HelpRequest joined={studentClass} look={look} />,
  });
  window.addEventListener("online", () => studentClass.reconnect());
  return () => {
    if (storedMembership(tab) === null) return;
    work = new ClassWork({
      services,
      words,
      tab,
      joined,
      request: (request) => simulator.send({ type: "class", request }),
      read: (url, request) => fetch(url, request),
      now: () => performance.now(),
      later,
    });
    const { session } = studentClass;
    work.follow(session.getState());
    session.subscribe((next) => work?.follow(next));
    window.addEventListener("pagehide", () => work?.flush());
    classes.setState({ menu: <ClassMenu joined={studentClass} work={work} /> });
  };
}

/** Closes dialogs and menus, which would cover the pause or be left open without use. */
function closeEverything(): void {
  for (const menu of document.querySelectorAll<HTMLElement>(":popover-open")) menu.hidePopover();
  for (const dialog of document.querySelectorAll<HTMLDialogElement>("dialog[open]")) dialog.close();
}
