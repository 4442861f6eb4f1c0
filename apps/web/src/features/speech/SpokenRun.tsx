/**
 * The page's live region, and the part that feeds it with the run. That part loads from a separate
 * file once the robot has started.
 */
import { useEffect, useRef } from "react";
import { useTranslation } from "react-i18next";
import { useServices } from "../../model/use-services.ts";
import type { Announcement } from "../../model/speech/speech.ts";

export function SpokenRun() {
  const services = useServices();
  const { i18n } = useTranslation();
  const region = useRef<HTMLOutputElement>(null);
  useEffect(() => {
    // Writes directly to the DOM, in the frame of the message. React would take as long as for all
    // the numbers.
    const write = ({ text }: Announcement): void => {
      // A new element each time, so that screen readers announce a repeated text again.
      const words = document.createElement("span");
      words.textContent = text;
      region.current?.replaceChildren(words);
    };
    const { announcement } = services.speech;
    write(announcement.getState());
    return announcement.subscribe(write);
  }, [services]);
  useEffect(() => {
    const { run } = services;
    let hasEnded = false;
    let end: (() => void) | null = null;
    let before = run.getState();
    const endWaiting = run.subscribe((state) => {
      // At the highest speed the goal event may arrive before the first frame of its run.
      if ((state.snapshot?.tick ?? 0) === 0 && state.event === before.event) {
        if (state.snapshot?.state !== "running") before = state;
        return;
      }
      endWaiting();
      void Promise.all([
        import("./announce-run.ts"),
        i18n.loadNamespaces(["diagnosis", "runDetails"]),
      ]).then(
        ([{ announceRun }]) => {
          const words = () => ({ t: i18n.t, language: i18n.language });
          const { nowTick, event } = run.getState();
          const isReset = nowTick === 0 && event === null;
          if (!hasEnded) end = announceRun(services, isReset ? state : before, words);
        },
        // If the file fails to load, the run is not announced. The screen shows everything.
        () => undefined,
      );
    });
    return () => {
      hasEnded = true;
      endWaiting();
      end?.();
    };
  }, [services, i18n]);
  return <output ref={region} id="spoken" className="visually-hidden" />;
}
