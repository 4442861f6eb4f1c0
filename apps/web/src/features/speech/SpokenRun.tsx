/**
 * The one live region of the page, and what feeds it with the run: that comes in a file of its own once
 * the robot has been let go.
 */
import { useEffect, useRef } from "react";
import { useTranslation } from "react-i18next";
import { useServices } from "../../app/services.ts";
import type { Said } from "./speech.ts";

export function SpokenRun() {
  const services = useServices();
  const { i18n } = useTranslation();
  const region = useRef<HTMLOutputElement>(null);
  useEffect(() => {
    // Written straight to the page, in the frame in which it is said: React would take as long as all the numbers.
    const write = ({ text }: Said): void => {
      // A new element each time: the same words said again are heard again.
      const words = document.createElement("span");
      words.textContent = text;
      region.current?.replaceChildren(words);
    };
    const { said } = services.speech;
    write(said.getState());
    return said.subscribe(write);
  }, [services]);
  useEffect(() => {
    const { run } = services;
    let hasEnded = false;
    let end: (() => void) | null = null;
    let before = run.getState();
    const endWaiting = run.subscribe((state) => {
      // At the greatest speed the goal may be told before the first frame of its run.
      if ((state.snapshot?.tick ?? 0) === 0 && state.event === before.event) {
        if (state.snapshot?.state !== "running") before = state;
        return;
      }
      endWaiting();
      void Promise.all([
        import("./tell-run.ts"),
        i18n.loadNamespaces(["diagnosis", "runDetails"]),
      ]).then(
        ([{ tellRun }]) => {
          const words = () => ({ t: i18n.t, language: i18n.language });
          if (!hasEnded) end = tellRun(services, before, words);
        },
        // Without its file the run is not spoken; everything on the screen tells it all the same.
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
