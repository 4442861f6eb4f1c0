/** Stage, task, controls and lines in a frame of another site, as high as their content. */
import { sizeOf } from "@corridor/maze";
import { ExternalLink } from "lucide";
import { useEffect, useRef } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import type { EmbeddedContent } from "../features/embed/embedded-content.ts";
import type { FrameProblem } from "@corridor/protocol";
import { MissionPlace } from "../features/lessons/OpenChallenge.tsx";
import { Stage } from "../features/maze-editor/Stage.tsx";
import { Messages } from "../features/messages/Messages.tsx";
import { ProgramEditor } from "../features/program-editor/ProgramEditor.tsx";
import { SpokenRun } from "../features/speech/SpokenRun.tsx";
import { sharedSearch } from "../model/preferences/language.ts";
import { isProgramRefused } from "../model/run/run-button.ts";
import { storyOf, storyText } from "../model/run/story.ts";
import { useRights } from "../model/use-rights.ts";
import { useServices } from "../model/use-services.ts";
import { Button } from "../ui/Button.tsx";
import { ErrorBoundary } from "../ui/ErrorBoundary.tsx";
import { Icon } from "../ui/Icon.tsx";
import styles from "./embedded-page.module.css";
import { RunControls } from "./RunControls.tsx";

interface EmbeddedPageProps {
  content: EmbeddedContent;
  /** called with the size of the page's content, in CSS pixels, whenever it changes */
  onSize: (width: number, height: number) => void;
}

/** Problems that another try may solve. */
const passing: readonly FrameProblem[] = ["wait", "offline"];

export function EmbeddedPage({ content, onSize }: EmbeddedPageProps) {
  const { t } = useTranslation(["embed", "words"]);
  const page = useRef<HTMLDivElement>(null);
  const view = useStore(content.view, (state) => state.view);
  useEffect(() => {
    const { current: element } = page;
    if (element === null) return undefined;
    // The page is as high as its content, whatever the height of the frame, so it can also shrink.
    const observer = new ResizeObserver(() => {
      onSize(Math.ceil(element.offsetWidth), Math.ceil(element.offsetHeight));
    });
    observer.observe(element);
    return () => observer.disconnect();
  }, [onSize]);
  return (
    <div ref={page} className={styles["page"]}>
      <ErrorBoundary onError={() => undefined}>
        {view.kind === "opening" && <p className={styles["note"]}>{t("words:offline.opening")}</p>}
        {view.kind === "problem" && (
          <div role="alert" className={styles["note"]}>
            <p>{t(`embed:problems.${view.problem}`)}</p>
            {passing.includes(view.problem) && (
              <Button onClick={() => void content.retry()}>{t("words:offline.tryAgain")}</Button>
            )}
          </div>
        )}
        {view.kind === "open" && <Content address={view.address} />}
      </ErrorBoundary>
    </div>
  );
}

function Content({ address }: { address: string }) {
  const { t } = useTranslation("embed");
  const { workspace, challenge } = useServices();
  const maze = useStore(workspace, (state) => state.maze);
  const lesson = useStore(challenge, (state) => state.lesson);
  const isByHand = isProgramRefused(useRights());
  const { columns, rows } = sizeOf(maze);
  const [path = "", hash] = address.split("#");
  return (
    <div className={styles["content"]}>
      <section className={styles["task"]} aria-label={t("task")}>
        {lesson !== null ? (
          <>
            <h1 className="visually-hidden">{lesson.name || t("task")}</h1>
            <MissionPlace />
          </>
        ) : (
          <>
            <h1 className={styles["name"]} dir="auto">
              {maze.name}
            </h1>
            <RunNote />
          </>
        )}
        {isByHand && <p>{t("byHand")}</p>}
      </section>
      <main className={styles["stage"]} style={{ aspectRatio: `${columns} / ${rows}` }}>
        <Stage hasTools={false} history={null} strip={null} sound={null} cards={() => null} />
        <Messages />
      </main>
      <div className={styles["controls"]}>
        <RunControls />
      </div>
      <aside className={styles["lines"]}>
        <ProgramEditor />
        <a
          className={styles["corridor"]}
          href={path + sharedSearch(location.search) + (hash === undefined ? "" : `#${hash}`)}
          target="_blank"
          rel="noopener noreferrer"
        >
          <Icon of={ExternalLink} size={16} />
          {t("open")}
        </a>
      </aside>
      <SpokenRun />
    </div>
  );
}

/** The newest bump or goal, in a maze without a task. */
function RunNote() {
  const { t, i18n } = useTranslation(["words", "runDetails"]);
  const { run } = useServices();
  const event = useStore(run, (state) => state.event);
  return (
    <p role="note" className={styles["event"]}>
      {event === null ? "" : storyText(t, storyOf(event), i18n.language)}
    </p>
  );
}
