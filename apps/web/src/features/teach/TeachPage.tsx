/** The pages for teachers: shows the view that the address names. */
import { useEffect, useRef, useState, useSyncExternalStore, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import type { KeyValueStorage } from "../../model/storage/key-value-storage.ts";
import { ErrorBoundary } from "../../ui/ErrorBoundary.tsx";
import { lazyPart } from "../../ui/lazy-part.tsx";
import { TeachFrame } from "./frame/TeachFrame.tsx";
import { TeachHome } from "./TeachHome.tsx";
import type { TeachSlots } from "./frame/teach-slots.ts";
import { teachViewOf, type TeachView } from "./frame/teach-view.ts";

const HandIns = lazyPart(async () => (await import("./HandIns.tsx")).HandIns);
const ReportView = lazyPart(async () => (await import("./report/ReportView.tsx")).ReportView);
const MakeLesson = lazyPart(async () => (await import("./make/MakeLesson.tsx")).MakeLesson);
const SavedLessonEditor = lazyPart(
  async () => (await import("./editor/SavedLessonEditor.tsx")).SavedLessonEditor,
);

const titles = {
  home: "teach:title",
  make: "teach:make.pageTitle",
  link: "teach:make.pageTitle",
  "hand-ins": "teach:handIns.pageTitle",
  report: "report:pageTitle",
} as const;

interface TeachPageProps {
  /** localStorage */
  device: KeyValueStorage;
  /** the buttons for theme and language */
  tools: ReactNode;
  slots: TeachSlots;
}

export function TeachPage({ device, tools, slots }: TeachPageProps) {
  const { t } = useTranslation(["teach", "report", "words"], { useSuspense: false });
  const hash = useSyncExternalStore(listenToAddress, () => location.hash);
  const view = teachViewOf(hash);
  const main = useFocusOnChange(view.name);
  return (
    <ErrorBoundary onError={() => undefined}>
      {view.name === "lesson" ? (
        <SavedLessonEditor
          key={view.id}
          id={view.id}
          device={device}
          tools={tools}
          slots={slots}
          main={main}
        />
      ) : (
        <TeachFrame title={t(titles[view.name])} end={tools} main={main}>
          <View view={view} device={device} />
        </TeachFrame>
      )}
    </ErrorBoundary>
  );
}

interface ViewProps {
  view: Exclude<TeachView, { name: "lesson" }>;
  device: KeyValueStorage;
}

function View({ view, device }: ViewProps) {
  switch (view.name) {
    case "home":
      return <TeachHome device={device} />;
    case "make":
      return <MakeLesson device={device} link={null} />;
    case "link":
      return <MakeLesson key={view.link} device={device} link={view.link} />;
    case "hand-ins":
      return <HandIns device={device} saved={view.lesson} />;
    case "report":
      return <ReportView key={view.report} device={device} saved={view.report} />;
  }
}

function listenToAddress(changed: () => void): () => void {
  window.addEventListener("hashchange", changed);
  return () => window.removeEventListener("hashchange", changed);
}

/** Moves the focus to the content when another view opens, as a new page would. */
function useFocusOnChange(key: unknown) {
  const main = useRef<HTMLElement>(null);
  const [first] = useState(key);
  const isFirst = useRef(true);
  useEffect(() => {
    if (isFirst.current && key === first) {
      isFirst.current = false;
      return;
    }
    // A field of the view may already have the focus.
    if (main.current?.contains(document.activeElement) !== true) main.current?.focus();
  }, [key, first]);
  return main;
}
