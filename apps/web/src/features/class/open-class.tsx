/** Connects the page to the class that its tab has joined. Loads only if there is one. */
import type { i18n } from "i18next";
import { storedMembership } from "../../model/classes/membership.ts";
import { StudentClass } from "../../model/classes/student-class.ts";
import type { Services } from "../../model/services.ts";
import type { KeyValueStorage } from "../../model/storage/key-value-storage.ts";
import { ClassMenu } from "./ClassMenu.tsx";
import { PauseBand } from "./PauseBand.tsx";

/** @param tab sessionStorage */
export async function openClass(
  { simulator, classes, screen }: Services,
  words: Pick<i18n, "t" | "loadNamespaces">,
  tab: KeyValueStorage,
): Promise<void> {
  const joined = storedMembership(tab);
  if (joined === null) return;
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
  const onEnd = () => classes.setState({ menu: null });
  const studentClass = new StudentClass(
    { simulator, screen, tab, words, now: Date.now, onPause, onEnd, later },
    joined,
  );
  classes.setState({ menu: <ClassMenu joined={studentClass} /> });
  window.addEventListener("online", () => studentClass.reconnect());
}

/** Closes dialogs and menus, which would cover the pause or be left open without use. */
function closeEverything(): void {
  for (const menu of document.querySelectorAll<HTMLElement>(":popover-open")) menu.hidePopover();
  for (const dialog of document.querySelectorAll<HTMLDialogElement>("dialog[open]")) dialog.close();
}
